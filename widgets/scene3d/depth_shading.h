#pragma once

#include <osg/Geometry>
#include <osg/Texture2D>
#include <osg/Uniform>
#include <osg/ref_ptr>

#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// Darkens the opaque bodies where the depth buffer is concave: in corners, holes and gaps, and beside bodies in front
/// of others (unsharp masking of the depth buffer, Luft, Colditz and Deussen 2006). Lines and transparent surfaces are
/// drawn after it and are not darkened.
class DepthShading {
 public:
  DepthShading();

  osg::Node* node() const { return quad_; }
  void setEnabled(bool enabled) { quad_->setNodeMask(enabled ? kWindowOnly : 0U); }
  /// Prepares a picture of this size in device pixels. `pixelsPerMetre`: across the view, at distance 1 with
  /// perspective, at any distance without. `pixelScale`: device pixels per pixel.
  void prepare(int width, int height, double nearPlane, double farPlane, bool orthographic, double pixelsPerMetre,
               double pixelScale);

 private:
  void setPairs(int count, int first);

  osg::ref_ptr<osg::Geometry> quad_;
  osg::ref_ptr<osg::Texture2D> depth_;
  osg::ref_ptr<osg::Uniform> planes_;
  osg::ref_ptr<osg::Uniform> reach_;
  osg::ref_ptr<osg::Uniform> pairs_;
  osg::ref_ptr<osg::Uniform> counts_;
};

}  // namespace glissade
