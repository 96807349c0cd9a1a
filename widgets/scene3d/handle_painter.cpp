#include "widgets/scene3d/handle_painter.h"

#include <QFontMetricsF>
#include <QPalette>

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

constexpr double kHandleBorder = 2.0;
constexpr double kShaftWidth = 2.5;
constexpr double kMarkedShaft = 5.0;
constexpr double kTipLength = 13.0;
constexpr double kTipWidth = 5.5;
constexpr double kMarkedTip = 1.35;
constexpr double kKnobRadius = 6.5;

}  // namespace

void HandlePainter::line(const QPolygonF& line, const QColor& colour, double width) const {
  QColor border = palette_.color(QPalette::Base);
  border.setAlphaF(0.75 * colour.alphaF());
  painter_.setBrush(Qt::NoBrush);
  painter_.setPen(QPen(border, width + kHandleBorder, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter_.drawPolyline(line);
  painter_.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter_.drawPolyline(line);
}

void HandlePainter::arrow(const QPointF& from, const QPointF& tip, const QColor& colour, bool marked) const {
  const QPointF along = tip - from;
  const double length = std::hypot(along.x(), along.y());
  if (length < 1.0) return;
  const QPointF ahead = along / length;
  const QPointF aside(-ahead.y(), ahead.x());
  const double larger = marked ? kMarkedTip : 1.0;
  const QPointF neck = tip - kTipLength * ahead;
  const QPointF point = tip + (larger - 1.0) * kTipLength * ahead;
  const QPolygonF head(
      QVector<QPointF>{point, neck + larger * kTipWidth * aside, neck - larger * kTipWidth * aside, point});
  line(QVector<QPointF>{from, neck}, colour, marked ? kMarkedShaft : kShaftWidth);
  line(head, colour, 1.0);
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(colour);
  painter_.drawPolygon(head);
}

void HandlePainter::knob(const QPointF& at, const QColor& colour, bool marked) const {
  const double radius = marked ? kMarkedTip * kKnobRadius : kKnobRadius;
  painter_.setPen(QPen(palette_.color(QPalette::Base), kHandleBorder));
  painter_.setBrush(colour);
  painter_.drawEllipse(at, radius, radius);
}

void HandlePainter::amount(const QString& text, const QPointF& pointer, const QSize& widget) const {
  QRectF box = QFontMetricsF(painter_.font()).boundingRect(text).adjusted(-6, -3, 6, 3);
  box.moveTopLeft(pointer + QPointF(16, 16));
  box.moveRight(std::min(box.right(), widget.width() - 4.0));
  box.moveBottom(std::min(box.bottom(), widget.height() - 4.0));
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(palette_.color(QPalette::Highlight));
  painter_.drawRoundedRect(box, 4, 4);
  painter_.setPen(palette_.color(QPalette::HighlightedText));
  painter_.drawText(box, Qt::AlignCenter, text);
}

}  // namespace glissade
