#pragma once

#include <QImage>
#include <memory>

namespace glissade {

/// An OpenGL context without a display. OSMesa implements it; a surfaceless context of EGL could.
class OffscreenContext {
 public:
  virtual ~OffscreenContext() = default;

  /// Makes the context current with a framebuffer of this size (pixels).
  virtual bool makeCurrent(int width, int height) = 0;
  /// The framebuffer, after all drawing is finished.
  virtual QImage read() = 0;
};

/// Throws std::runtime_error if the process's OpenGL is not OSMesa's (wrong link order) or no context can be made.
std::unique_ptr<OffscreenContext> makeOsMesaContext();

}  // namespace glissade
