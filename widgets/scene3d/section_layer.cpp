#include "widgets/scene3d/section_layer.h"

#include <osg/ClipPlane>

#include <algorithm>

namespace glissade {
SectionClip::SectionClip() : clip_(new osg::ClipNode) {}

void SectionClip::setSections(const std::vector<Plane>& sections, const std::vector<osg::Group*>& layers,
                              double slack) {
  for (osg::Group* layer : layers) {
    for (std::size_t i = 0; i < kMostSections; ++i) {
      layer->getOrCreateStateSet()->removeMode(GL_CLIP_PLANE0 + static_cast<GLenum>(i));
    }
  }
  clip_->getClipPlaneList().clear();
  for (std::size_t i = 0; i < std::min(sections.size(), kMostSections); ++i) {
    const Plane& section = sections[i];
    const osg::Vec4d kept(-section.normal.x(), -section.normal.y(), -section.normal.z(), section.offset - slack);
    clip_->addClipPlane(new osg::ClipPlane(static_cast<unsigned>(i), kept));
    for (osg::Group* layer : layers) {
      layer->getOrCreateStateSet()->setMode(GL_CLIP_PLANE0 + static_cast<GLenum>(i), osg::StateAttribute::ON);
    }
  }
  // The planes are switched on for the layers only; nodes beside them are not cut.
  clip_->setLocalStateSetModes(osg::StateAttribute::OFF);
}

}  // namespace glissade
