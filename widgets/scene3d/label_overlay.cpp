#include "widgets/scene3d/label_overlay.h"

#include <QEvent>
#include <QFontMetrics>
#include <QPainter>

#include <cmath>
#include <optional>

#include "widgets/scene3d/camera_controller.h"

namespace glissade {
namespace {

/// Where a point of the scene is in a widget of the given size; nothing behind the eye.
std::optional<QPointF> project(const CameraController& camera, const Vector3& p_W, const QSize& size) {
  const Vector3 p_V = camera.R_WV().conjugate() * (p_W - camera.eye());
  if (p_V.z() > -camera.nearPlane()) return std::nullopt;
  const double scale = size.height() / (2.0 * std::tan(camera.verticalFieldOfView() / 2.0));
  return QPointF(size.width() / 2.0 - p_V.x() / p_V.z() * scale, size.height() / 2.0 + p_V.y() / p_V.z() * scale);
}

}  // namespace

LabelOverlay::LabelOverlay(const SceneView& view, QWidget* scene) : QWidget(scene), view_(view) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  scene->installEventFilter(this);
  resize(scene->size());
}

bool LabelOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) resize(static_cast<QWidget*>(watched)->size());
  return QWidget::eventFilter(watched, event);
}

void LabelOverlay::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QFontMetrics metrics(font());
  for (const SceneLabel& label : view_.labels()) {
    const auto at = project(view_.camera(), label.p_W, size());
    if (!at) continue;
    const QString text = QString::fromStdString(label.text);
    QRectF box = metrics.boundingRect(text);
    box.adjust(-5, -2, 5, 2);
    box.moveCenter(*at + QPointF(0, label.below ? box.height() : 0));
    QColor ground = palette().color(label.strong ? QPalette::Highlight : QPalette::Base);
    ground.setAlphaF(label.strong ? 0.95 : 0.75);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(palette().color(label.strong ? QPalette::HighlightedText : QPalette::Text));
    painter.drawText(box, Qt::AlignCenter, text);
  }
}

}  // namespace glissade
