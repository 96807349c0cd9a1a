#pragma once

#include <QWidget>

#include <functional>
#include <optional>

#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// A cube in a corner of the scene that turns with it. A click on a face, an edge or a corner looks from there; the
/// arrow keys turn the view in steps of 45 degrees, Home looks from the usual corner.
class ViewCube final : public QWidget {
  Q_OBJECT

 public:
  /// The cube stays in the upper right corner of `scene`, which shows `view`.
  ViewCube(const SceneView& view, QWidget* scene);

  /// The direction for a point of the widget: -1, 0 or 1 along each axis of the world; nothing beside the cube.
  std::optional<Vector3> directionAt(const QPointF& at) const;

 signals:
  /// The user wants to look from this direction.
  void lookFrom(const glissade::Vector3& towardsEye);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QPointF pointOf(const Vector3& p) const;
  void goToCorner(const QSize& scene);
  void paintFace(QPainter& painter, int axis, double side) const;
  void turnBy(double yaw, double pitch);

  const SceneView& view_;
  std::optional<Vector3> hovered_;
};

}  // namespace glissade
