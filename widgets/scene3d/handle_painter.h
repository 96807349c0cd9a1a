#pragma once

#include <QColor>
#include <QPainter>
#include <QPolygonF>

namespace glissade {

/// Draws handles over the scene, with a border that sets them off from the background.
class HandlePainter {
 public:
  HandlePainter(QPainter& painter, const QPalette& palette) : painter_(painter), palette_(palette) {}

  void line(const QPolygonF& line, const QColor& colour, double width) const;
  /// `marked`: the handle is under the pointer, or dragged.
  void arrow(const QPointF& from, const QPointF& tip, const QColor& colour, bool marked) const;
  /// Draws a disc.
  void knob(const QPointF& at, const QColor& colour, bool marked) const;
  /// Draws the amount of a drag beside the pointer, inside a widget of this size.
  void amount(const QString& text, const QPointF& pointer, const QSize& widget) const;

 private:
  QPainter& painter_;
  const QPalette& palette_;
};

}  // namespace glissade
