#pragma once

#include <QWidget>

#include <optional>

#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// Base of widgets that are painted over the widget that shows the scene. It covers that widget and follows its size.
/// It ignores mouse and keys, and pictures and films of the scene do not contain it.
class SceneOverlay : public QWidget {
  Q_OBJECT

 public:
  /// The overlay covers `scene`, which shows `view`.
  SceneOverlay(const SceneView& view, QWidget* scene);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  const SceneView& view() const { return view_; }
  /// The place of a point in pixels of the widget; nothing if the point is behind the camera.
  std::optional<QPointF> onScreen(const Vector3& p_W) const;
  /// The place of a point for another camera.
  std::optional<QPointF> onScreen(const CameraController& camera, const Vector3& p_W) const;

 private:
  const SceneView& view_;
};

}  // namespace glissade
