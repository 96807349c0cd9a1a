#pragma once

#include "widgets/scene3d/scene_overlay.h"

namespace glissade {

/// The legend of the scene's colours: a row for each kind of thing that is drawn now, in the lower right corner of the
/// widget that shows the scene. Rows without room are left out. It ignores mouse and keys.
class LegendOverlay final : public SceneOverlay {
  Q_OBJECT

 public:
  /// The overlay covers `scene`, which shows `view`, and follows its size.
  LegendOverlay(const SceneView& view, QWidget* scene);

  /// The area of the scene that it covers; empty: nothing is shown.
  QRect box() const;
  /// The texts of the rows that are shown.
  QStringList texts() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// The rows that have room.
  std::vector<LegendRow> rows() const;
  /// The lower and the upper limit that other widgets leave free at the right border.
  int floor() const;
  int ceiling() const;
  int rowHeight() const;
  int swatchWidth() const;
  QRect boxOf(const std::vector<LegendRow>& rows) const;
  void paintSwatch(QPainter& painter, const LegendRow& row, const QRectF& box) const;
};

}  // namespace glissade
