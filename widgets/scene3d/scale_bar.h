#pragma once

#include <QWidget>

#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// A bar of a round length at the scale of the scene; with perspective it is valid at the depth of the camera's focus.
struct ScaleLength {
  double metres = 0.0;
  double pixels = 0.0;  ///< length on the screen
};

/// The longest length of 1, 2 or 5 times a power of ten of units that is drawn with at most `mostPixels`. `unit`:
/// metres.
ScaleLength roundScale(double metresPerPixel, double mostPixels, double unit = 1.0);

/// The axes of the world and the scale of the scene, in its lower left corner. They ignore mouse and keys.
class ScaleBar final : public QWidget {
  Q_OBJECT

 public:
  ScaleBar(const SceneView& view, QWidget* scene);

  /// Sets the height in pixels that another widget covers at the lower border of the scene; the bar stays above it.
  void setRoomBelow(int pixels);

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void goToCorner(const QSize& scene);
  void paintAxes(QPainter& painter) const;

  const SceneView& view_;
  int roomBelow_ = 0;
};

}  // namespace glissade
