#pragma once

#include <osgViewer/Viewer>

#include "widgets/scene3d/detail_control.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// Draws a SceneView into the current OpenGL context; the on-screen and the offscreen widget share it.
class SceneRenderer {
 public:
  explicit SceneRenderer(SceneView& view);

  /// Sets the size in device pixels; the camera takes its ratio.
  void resize(int width, int height);
  /// Renders one frame into the framebuffer object `target` (0: the context's own), in full detail.
  void render(unsigned int target);
  /// Renders one frame in this detail, into a target of another size.
  void render(unsigned int target, int width, int height, const PictureDetail& detail);

 private:
  void setProjection();

  SceneView& view_;
  int width_ = 64;
  int height_ = 64;
  osg::ref_ptr<osgViewer::Viewer> viewer_;
  osg::ref_ptr<osgViewer::GraphicsWindowEmbedded> window_;
};

}  // namespace glissade
