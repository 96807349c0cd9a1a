#pragma once

#include <QWidget>

#include <optional>

#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// What is painted over the widget that shows the scene. It covers that widget and follows its size. It takes no part
/// in mouse and keys, and pictures and films of the scene do not have it.
class SceneOverlay : public QWidget {
  Q_OBJECT

 public:
  /// Covers `scene`, which shows `view`.
  SceneOverlay(const SceneView& view, QWidget* scene);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  const SceneView& view() const { return view_; }
  /// Where a point is seen, in pixels of the widget; nothing where it is behind the camera.
  std::optional<QPointF> onScreen(const Vector3& p_W) const;
  /// The same for another camera.
  std::optional<QPointF> onScreen(const CameraController& camera, const Vector3& p_W) const;

 private:
  const SceneView& view_;
};

}  // namespace glissade
