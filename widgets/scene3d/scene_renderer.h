#pragma once

#include <osgViewer/Viewer>

#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// Draws a SceneView into the OpenGL context that is current: the part that the on-screen and the
/// offscreen widget share.
class SceneRenderer {
 public:
  explicit SceneRenderer(SceneView& view);

  /// Size in device pixels.
  void resize(int width, int height);
  /// Renders one frame into the framebuffer object `target` (0: the context's own).
  void render(unsigned int target);

 private:
  SceneView& view_;
  osg::ref_ptr<osgViewer::Viewer> viewer_;
  osg::ref_ptr<osgViewer::GraphicsWindowEmbedded> window_;
};

}  // namespace glissade
