#pragma once

#include <QImage>
#include <QWidget>
#include <memory>

namespace glissade {

/// Shows each eye a picture by the driver's buffers, in a window inside a window, which lets the mouse through.
class QuadBuffer {
 public:
  virtual ~QuadBuffer() = default;

  virtual QWidget* widget() = 0;
  /// Shows pictures of the widget's size in device pixels.
  virtual void show(const QImage& left, const QImage& right) = 0;
};

/// Null if the driver gives no context with two buffers for each eye. It is in the library glissade_onscreen.
std::unique_ptr<QuadBuffer> makeQuadBufferWindow(QWidget* parent);

}  // namespace glissade
