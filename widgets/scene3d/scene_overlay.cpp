#include "widgets/scene3d/scene_overlay.h"

#include <QEvent>

#include "widgets/scene3d/camera_controller.h"

namespace glissade {

SceneOverlay::SceneOverlay(const SceneView& view, QWidget* scene) : QWidget(scene), view_(view) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  scene->installEventFilter(this);
  resize(scene->size());
}

bool SceneOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) resize(static_cast<QWidget*>(watched)->size());
  return QWidget::eventFilter(watched, event);
}

std::optional<QPointF> SceneOverlay::onScreen(const Vector3& p_W) const { return onScreen(view_.camera(), p_W); }

std::optional<QPointF> SceneOverlay::onScreen(const CameraController& camera, const Vector3& p_W) const {
  const auto at = camera.project(p_W);
  if (!at) return std::nullopt;
  return QPointF(width() / 2.0 + at->x() * height(), height() / 2.0 + at->y() * height());
}

}  // namespace glissade
