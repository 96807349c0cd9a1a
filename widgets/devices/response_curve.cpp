#include "widgets/devices/response_curve.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace glissade {
namespace {

constexpr int kPoints = 200;
constexpr double kMargin = 6.0;

}  // namespace

ResponseCurve::ResponseCurve(QWidget* parent) : QWidget(parent) {
  setToolTip(tr("How the device's deflection (across) is answered (up); the dot is where it is now"));
}

void ResponseCurve::setAxis(const QString& title, const AxisShaping& axis) {
  title_ = title;
  axis_ = axis;
  update();
}

void ResponseCurve::setRaw(double raw) {
  if (raw == raw_) return;
  raw_ = raw;
  update();
}

void ResponseCurve::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const int line = fontMetrics().height();
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(QRect(0, 0, width(), line), Qt::AlignCenter, title_);
  const double side = std::min<double>(width(), height() - line) - 2.0 * kMargin;
  const QRectF area(0.5 * (width() - side), line + kMargin, side, side);
  const auto at = [&](double raw, double shaped) {
    return QPointF(area.center().x() + 0.5 * side * raw, area.center().y() - 0.5 * side * shaped);
  };
  painter.setBrush(palette().base());
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawRect(area);
  painter.drawLine(at(-1, 0), at(1, 0));
  painter.drawLine(at(0, -1), at(0, 1));
  QPainterPath curve(at(-1, shapeAxis(axis_, -1)));
  for (int i = 1; i <= kPoints; ++i) {
    const double raw = -1.0 + 2.0 * i / kPoints;
    curve.lineTo(at(raw, shapeAxis(axis_, raw)));
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
  painter.drawPath(curve);
  painter.setBrush(palette().color(QPalette::WindowText));
  painter.setPen(Qt::NoPen);
  painter.drawEllipse(at(std::clamp(raw_, -1.0, 1.0), shapeAxis(axis_, raw_)), 4.0, 4.0);
}

}  // namespace glissade
