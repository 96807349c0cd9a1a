#pragma once

#include <QPainter>

#include "widgets/scene3d/scene_overlay.h"

namespace glissade {

class LegendOverlay;

/// The text of a label in the user's language and unit.
QString labelText(const SceneLabel& label);

/// The scene's labels, painted over the widget that shows it, without overlaps. They ignore mouse and keys.
class LabelOverlay final : public SceneOverlay {
  Q_OBJECT

 public:
  /// The overlay covers `scene`, which shows `view`, and follows its size. No label is placed on the area of `legend`.
  LabelOverlay(const SceneView& view, const LegendOverlay& legend, QWidget* scene);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QFont fontOf(const SceneLabel& label) const;
  /// The preferred box of a label whose point is drawn at `at`.
  QRectF boxOf(const SceneLabel& label, const QPointF& at) const;
  void paint(QPainter& painter, const SceneLabel& label, const QRectF& box) const;

  const LegendOverlay& legend_;
};

}  // namespace glissade
