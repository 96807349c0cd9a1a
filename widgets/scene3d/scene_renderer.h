#pragma once

#include <osgViewer/Viewer>

#include <functional>

#include "widgets/scene3d/detail_control.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// Draws a SceneView into the OpenGL context that is current: the part that the on-screen and the
/// offscreen widget share.
class SceneRenderer {
 public:
  explicit SceneRenderer(SceneView& view);

  /// Size in device pixels.
  void resize(int width, int height);
  /// Renders one frame into the framebuffer object `target` (0: the context's own), in full detail.
  void render(unsigned int target);
  /// The same for a person who turns the view: in less detail where bodies are small or pictures take long. True: the
  /// next picture from here is a finer one. `finish` waits until OpenGL has drawn.
  bool renderInteractively(unsigned int target, const std::function<void()>& finish);

 private:
  /// `tolerance`: device pixels that what is drawn may be off.
  void draw(unsigned int target, double tolerance);

  SceneView& view_;
  DetailControl detail_;
  osg::ref_ptr<osgViewer::Viewer> viewer_;
  osg::ref_ptr<osgViewer::GraphicsWindowEmbedded> window_;
};

}  // namespace glissade
