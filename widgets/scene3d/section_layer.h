#pragma once

#include <osg/ClipNode>
#include <osg/Group>
#include <osg/ref_ptr>

#include <vector>

#include "engine/environment/rigid_body.h"
#include "engine/geometry/plane_section.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

/// OpenGL guarantees six clip planes; more sections are not drawn.
inline constexpr std::size_t kMostSections = 6;

/// Cuts away what lies on the side of a section's normal, of those layers that it is applied to.
class SectionClip {
 public:
  SectionClip();

  /// Belongs into the scene, beside the layers.
  osg::Node* node() const { return clip_; }
  /// `layers` are cut by these sections, and by no others any more.
  void setSections(const std::vector<Plane>& sections, const std::vector<osg::Group*>& layers);

 private:
  osg::ref_ptr<osg::ClipNode> clip_;
};

/// The cut face of a body in one section, filled and outlined; null where the section does not meet it.
osg::ref_ptr<osg::Group> makeCap(const RigidBody& body, const Plane& section, const ScenePalette& palette);

}  // namespace glissade
