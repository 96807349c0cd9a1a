#include "widgets/scene3d/scale_bar.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "widgets/commands/length_text.h"
#include "widgets/scene3d/camera_controller.h"

namespace glissade {
namespace {

constexpr double kMostBarPixels = 130.0;
constexpr int kBarMargin = 10;

}  // namespace

ScaleLength roundScale(double metresPerPixel, double mostPixels) {
  const double most = metresPerPixel * mostPixels;
  if (!(most > 0.0) || !std::isfinite(most)) return {};
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  double metres = power;
  for (const double factor : {2.0, 5.0}) {
    if (factor * power <= most) metres = factor * power;
  }
  return {metres, metres / metresPerPixel};
}

ScaleBar::ScaleBar(const SceneView& view, QWidget* scene) : QWidget(scene), view_(view) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  setObjectName(QStringLiteral("scale-bar"));
  resize(static_cast<int>(kMostBarPixels) + 12, 30);
  scene->installEventFilter(this);
  goToCorner(scene->size());
}

bool ScaleBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) goToCorner(static_cast<QWidget*>(watched)->size());
  return QWidget::eventFilter(watched, event);
}

void ScaleBar::goToCorner(const QSize& scene) { move(kBarMargin, scene.height() - height() - kBarMargin); }

void ScaleBar::paintEvent(QPaintEvent* /*event*/) {
  const double perPixel = view_.camera().viewHeight() / std::max(1, parentWidget()->height());
  const ScaleLength scale = roundScale(perPixel, kMostBarPixels);
  if (scale.metres <= 0.0) return;
  QPainter painter(this);
  painter.setPen(QPen(palette().color(QPalette::Text), 1.5));
  const double y = height() - 5.5;
  painter.drawLine(QPointF(2, y), QPointF(2 + scale.pixels, y));
  for (const double x : {2.0, 2.0 + scale.pixels}) painter.drawLine(QPointF(x, y - 5), QPointF(x, y));
  painter.drawText(QRectF(2, 0, scale.pixels, y - 2), Qt::AlignCenter, lengthText(scale.metres));
}

}  // namespace glissade
