#pragma once

#include <QMouseEvent>

#include <cmath>
#include <optional>

namespace glissade {

/// Tells clicks of the left button from drags.
class LeftClick {
 public:
  /// Follows a press or a release. Returns the place of the click that a release ends; nothing for a press and a drag.
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
