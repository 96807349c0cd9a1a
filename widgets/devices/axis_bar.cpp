#include "widgets/devices/axis_bar.h"

#include <QPainter>

#include <algorithm>

namespace glissade {
namespace {

/// From the middle of `area` to the share of its half width.
QRectF barOf(const QRectF& area, double share) {
  const double middle = area.center().x();
  const double end = middle + 0.5 * area.width() * std::clamp(share, -1.0, 1.0);
  return {QPointF(std::min(middle, end), area.top()), QPointF(std::max(middle, end), area.bottom())};
}

}  // namespace

AxisBar::AxisBar(QWidget* parent) : QWidget(parent) {
  setToolTip(tr("Thin: as the device reports it. Thick: after shaping. Hatched: the dead zone."));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void AxisBar::setValues(double raw, double shaped) {
  if (raw == raw_ && shaped == shaped_) return;
  raw_ = raw;
  shaped_ = shaped;
  update();
}

void AxisBar::setDeadZone(double deadZone) {
  deadZone_ = deadZone;
  update();
}

void AxisBar::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const QRectF area = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.setPen(palette().color(QPalette::Mid));
  painter.setBrush(palette().base());
  painter.drawRect(area);
  const QRectF thin(area.left(), area.top() + 2.0, area.width(), 0.25 * area.height());
  const QRectF thick(area.left(), thin.bottom() + 2.0, area.width(), area.bottom() - thin.bottom() - 4.0);
  painter.fillRect(barOf(area, deadZone_).united(barOf(area, -deadZone_)),
                   QBrush(palette().color(QPalette::PlaceholderText), Qt::BDiagPattern));
  painter.fillRect(barOf(thin, raw_), palette().color(QPalette::Text));
  painter.fillRect(barOf(thick, shaped_), palette().color(QPalette::Highlight));
  painter.drawLine(QPointF(area.center().x(), area.top()), QPointF(area.center().x(), area.bottom()));
}

}  // namespace glissade
