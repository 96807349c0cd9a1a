#pragma once

#include "widgets/scene3d/scene_overlay.h"

namespace glissade {

/// What the colours of the scene mean: a row for each thing that is drawn now, in the lower right corner of the widget
/// that shows the scene. It has no rows for which there is no room, and takes no part in mouse and keys.
class LegendOverlay final : public SceneOverlay {
  Q_OBJECT

 public:
  /// Covers `scene`, which shows `view`, and follows its size.
  LegendOverlay(const SceneView& view, QWidget* scene);

  /// What it covers of the scene; empty: nothing is shown.
  QRect box() const;
  /// The rows that are shown, as people read them.
  QStringList texts() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// The rows for which there is room.
  std::vector<LegendRow> rows() const;
  /// The lowest and the highest place that other widgets leave free at the right border.
  int floor() const;
  int ceiling() const;
  int rowHeight() const;
  int swatchWidth() const;
  QRect boxOf(const std::vector<LegendRow>& rows) const;
  void paintSwatch(QPainter& painter, const LegendRow& row, const QRectF& box) const;
};

}  // namespace glissade
