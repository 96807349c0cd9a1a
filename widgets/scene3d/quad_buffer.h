#pragma once

#include <QImage>
#include <QWidget>
#include <memory>

namespace glissade {

/// Gives each eye a picture through buffers of the driver's own: a window in a window, which the mouse passes through.
class QuadBuffer {
 public:
  virtual ~QuadBuffer() = default;

  virtual QWidget* widget() = 0;
  /// Pictures of the widget's size in device pixels.
  virtual void show(const QImage& left, const QImage& right) = 0;
};

/// Null where the driver gives no context with two buffers for each eye. Library glissade_onscreen.
std::unique_ptr<QuadBuffer> makeQuadBufferWindow(QWidget* parent);

}  // namespace glissade
