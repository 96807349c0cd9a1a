#pragma once

#include <QImage>
#include <memory>

namespace glissade {

/// An OpenGL context without a display. OSMesa today; an EGL surfaceless one fits behind it.
class OffscreenContext {
 public:
  virtual ~OffscreenContext() = default;

  /// Makes the context current with a framebuffer of this size (pixels).
  virtual bool makeCurrent(int width, int height) = 0;
  /// The framebuffer after everything drawn has arrived.
  virtual QImage read() = 0;
};

/// Throws std::runtime_error where the process's OpenGL is not OSMesa's (wrong link order) or no
/// context can be had.
std::unique_ptr<OffscreenContext> makeOsMesaContext();

}  // namespace glissade
