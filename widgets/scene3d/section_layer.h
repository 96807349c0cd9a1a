#pragma once

#include <osg/ClipNode>
#include <osg/Group>
#include <osg/ref_ptr>

#include <vector>

#include "engine/geometry/plane_section.h"

namespace glissade {

/// OpenGL guarantees six clip planes; more sections are not drawn.
inline constexpr std::size_t kMostSections = 6;

/// Cuts away what lies on the side of a section's normal, of those layers that it is applied to.
class SectionClip {
 public:
  SectionClip();

  /// Belongs into the scene, beside the layers.
  osg::Node* node() const { return clip_; }
  /// `layers` are cut by these sections, and by no others any more. A face that lies in a section is cut away, too:
  /// `slack` metres are for the rounding of the graphics card.
  void setSections(const std::vector<Plane>& sections, const std::vector<osg::Group*>& layers, double slack);

 private:
  osg::ref_ptr<osg::ClipNode> clip_;
};

}  // namespace glissade
