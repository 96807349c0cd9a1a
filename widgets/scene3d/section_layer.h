#pragma once

#include <osg/ClipNode>
#include <osg/Group>
#include <osg/ref_ptr>

#include <vector>

#include "engine/geometry/plane_section.h"

namespace glissade {

/// OpenGL guarantees six clip planes; more sections are not drawn.
inline constexpr std::size_t kMostSections = 6;

/// Cuts away the parts of some layers that are on the side of a section's normal.
class SectionClip {
 public:
  SectionClip();

  /// The node that has to be in the scene, beside the layers.
  osg::Node* node() const { return clip_; }
  /// Cuts only `layers` by these sections. A face that lies in a section is cut away, too; `slack` metres allow for the
  /// rounding of the graphics card.
  void setSections(const std::vector<Plane>& sections, const std::vector<osg::Group*>& layers, double slack);

 private:
  osg::ref_ptr<osg::ClipNode> clip_;
};

}  // namespace glissade
