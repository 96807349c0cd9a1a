#pragma once

#include <QPainter>

#include "widgets/scene3d/scene_overlay.h"

namespace glissade {

class LegendOverlay;

/// What a label says, as the user's language and unit write it.
QString labelText(const SceneLabel& label);

/// The scene's labels, painted over the widget that shows it, none on another; takes no part in mouse and keys.
class LabelOverlay final : public SceneOverlay {
  Q_OBJECT

 public:
  /// Covers `scene`, which shows `view`, and follows its size.
  /// No label is put on what `legend` covers.
  LabelOverlay(const SceneView& view, const LegendOverlay& legend, QWidget* scene);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QFont fontOf(const SceneLabel& label) const;
  /// Where a label wants to be whose point is drawn there.
  QRectF boxOf(const SceneLabel& label, const QPointF& at) const;
  void paint(QPainter& painter, const SceneLabel& label, const QRectF& box) const;

  const LegendOverlay& legend_;
};

}  // namespace glissade
