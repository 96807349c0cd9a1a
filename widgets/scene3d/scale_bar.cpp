#include "widgets/scene3d/scale_bar.h"

#include <QEvent>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/controls/length_text.h"
#include "widgets/scene3d/axis_colours.h"
#include "widgets/scene3d/camera_controller.h"

namespace glissade {
namespace {

constexpr double kMostBarPixels = 130.0;
constexpr int kBarMargin = 10;
constexpr int kAxesSize = 64;
/// Distance between the bar and the spacing of the grid beside it.
constexpr double kGridGap = 14.0;
constexpr int kGridTextWidth = 130;
constexpr double kAxisPixels = 22.0;

}  // namespace

ScaleLength roundScale(double metresPerPixel, double mostPixels, double unit) {
  const double most = metresPerPixel * mostPixels / unit;
  if (!(most > 0.0) || !std::isfinite(most)) return {};
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  double units = power;
  for (const double factor : {2.0, 5.0}) {
    if (factor * power <= most) units = factor * power;
  }
  return {units * unit, units * unit / metresPerPixel};
}

ScaleBar::ScaleBar(const SceneView& view, QWidget* scene) : QWidget(scene), view_(view) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  setObjectName(QStringLiteral("scale-bar"));
  resize(static_cast<int>(kMostBarPixels) + 12 + kGridTextWidth, kAxesSize + 30);
  scene->installEventFilter(this);
  goToCorner(scene->size());
}

bool ScaleBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) goToCorner(static_cast<QWidget*>(watched)->size());
  return QWidget::eventFilter(watched, event);
}

void ScaleBar::goToCorner(const QSize& scene) { move(kBarMargin, scene.height() - height() - kBarMargin - roomBelow_); }

void ScaleBar::setRoomBelow(int pixels) {
  roomBelow_ = pixels;
  goToCorner(parentWidget()->size());
}

void ScaleBar::paintEvent(QPaintEvent* /*event*/) {
  const double perPixel = view_.camera().viewHeight() / std::max(1, parentWidget()->height());
  const ScaleLength scale = roundScale(perPixel, kMostBarPixels, roundLengthUnit());
  if (scale.metres <= 0.0) return;
  QPainter painter(this);
  painter.setPen(QPen(view_.hasDarkBackground() ? Qt::white : Qt::black, 1.5));
  const double y = height() - 5.5;
  painter.drawLine(QPointF(2, y), QPointF(2 + scale.pixels, y));
  for (const double x : {2.0, 2.0 + scale.pixels}) painter.drawLine(QPointF(x, y - 5), QPointF(x, y));
  const QString length = lengthText(scale.metres);
  const double across = std::max(scale.pixels, QFontMetricsF(font()).horizontalAdvance(length));
  painter.drawText(QRectF(2, kAxesSize, across, y - 2 - kAxesSize), Qt::AlignCenter, length);
  if (const auto spacing = view_.gridSpacing()) {
    painter.drawText(QRectF(across + kGridGap, kAxesSize, width(), height() - kAxesSize),
                     Qt::AlignLeft | Qt::AlignVCenter, tr("grid %1").arg(lengthText(*spacing)));
  }
  paintAxes(painter);
}

/// Paints the axes; those that point to the viewer are drawn last.
void ScaleBar::paintAxes(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  const Quaternion toView = view_.camera().R_WV().conjugate();
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&toView](int a, int b) {
    return (toView * Vector3(Vector3::Unit(a))).z() < (toView * Vector3(Vector3::Unit(b))).z();
  });
  const QPointF origin(kAxesSize / 2.0, kAxesSize / 2.0);
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  for (const int axis : order) {
    const Vector3 along = toView * Vector3(Vector3::Unit(axis));
    const QPointF direction(along.x(), -along.y());
    painter.setPen(QPen(QColor(kAxisColours[static_cast<std::size_t>(axis)]), 2.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(origin, origin + kAxisPixels * direction);
    const QPointF end = origin + (kAxisPixels + 7.0) * direction;
    const QRectF box(end.x() - 8, end.y() - 8, 16, 16);
    painter.drawText(box, Qt::AlignCenter, QString(QLatin1Char("XYZ"[axis])));
  }
}

}  // namespace glissade
