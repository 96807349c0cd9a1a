#pragma once

#include <QMouseEvent>

#include <cmath>
#include <optional>

namespace glissade {

/// Distinguishes clicks of the left button from drags.
class LeftClick {
 public:
  /// Follows a press or a release. Returns the position of a click at its release; nothing for a press and for a drag.
  std::optional<QPointF> follow(const QMouseEvent& event) {
    if (event.type() == QEvent::MouseButtonPress) {
      pressed_ = event.localPos();
      return std::nullopt;
    }
    const QPointF moved = event.localPos() - pressed_;
    return std::hypot(moved.x(), moved.y()) < kStillPixels ? std::optional(event.localPos()) : std::nullopt;
  }

 private:
  static constexpr double kStillPixels = 4.0;

  QPointF pressed_;
};

}  // namespace glissade
