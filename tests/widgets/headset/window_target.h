// A replacement for the window's drawing: a context of the calling thread and a picture with several samples for each
// pixel.
#pragma once

#include <QImage>
#include <memory>

namespace glissade {
class SceneView;
class SceneRenderer;
}  // namespace glissade

namespace glissade::test {

class WindowTarget {
 public:
  WindowTarget(int width, int height);
  ~WindowTarget();

  void draw(SceneView& view);
  QImage picture(SceneView& view);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glissade::test
