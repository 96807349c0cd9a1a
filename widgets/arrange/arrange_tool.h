#pragma once

#include <QKeyEvent>

#include <variant>

#include "widgets/arrange/arrange_snapping.h"
#include "widgets/document/workbench_document.h"
#include "widgets/scene3d/gizmo_overlay.h"
#include "widgets/scene3d/pose_drag.h"
#include "widgets/workbench/drag_tool.h"

namespace glissade {

/// The arranged item and the pose of its gizmo.
struct ArrangedItem {
  AssemblyItem item;
  Pose X_BG;             ///< in the same frame as the item's pose
  bool ownAxes = false;  ///< the gizmo has the axes of X_BG; else those of the world
};

/// While the tool is on, a person moves bodies and the object's ghosts at its start and its goal. A gizmo at the
/// selected item moves it along the gizmo's axes and turns it about them, by the pointer or by keys. A body that is
/// gripped itself moves in the plane of the view, and turns about the view's axes. Bodies and ghosts keep their poses
/// in the scenario until they are dropped.
class ArrangeTool final : public DragTool {
  Q_OBJECT

 public:
  ArrangeTool(const WorkbenchDocument& document, SceneWidget& scene, ArrangeSnapping& features, QObject* parent);

  void setOn(bool on);
  /// The selected item has the gizmo, and can be gripped also behind other bodies.
  void setSelected(const std::optional<ArrangedItem>& selected);
  /// Amounts are rounded to the steps. Ctrl suspends rounding and the snapping to features; if both are off, Ctrl
  /// rounds.
  void setSnapping(bool snapping, const GizmoSteps& steps);

  const GizmoOverlay& gizmo() const { return *gizmo_; }

 signals:
  /// The feature that the dragged item meets now; empty: none.
  void snapped(const QString& what);
  void gripped(const glissade::AssemblyItem& item);
  void dropped(const glissade::AssemblyItem& item, const glissade::Pose& X_WB);
  /// A key moved the item.
  void nudged(const glissade::AssemblyItem& item, const glissade::Pose& X_WB);
  /// Esc was pressed while nothing was held.
  void left();

 private:
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool grip(const QPointF& position) override;
  bool holds() const override { return inHand_.has_value(); }
  void moveTo(const QPointF& position) override;
  void turn(const QPointF& position, const QPointF& by) override;
  void drop() override;

  bool gripHandle(const QPointF& position);
  bool gripBody(const QPointF& position);
  void dragHandle(const QPointF& position, bool suspended);
  /// The amount that the handle's drag is rounded to, by features of other bodies or by steps.
  GizmoAmount snappedAmount(const GizmoDrag& drag, bool suspended);
  void showSnap(const FeatureSnap& snap);
  /// Puts back the held item.
  void restoreHeldItem();
  bool pressKey(const QKeyEvent& event);
  void nudge(int viewAxis, double sign, bool turning);
  void hover(const QPointF& position);
  void followDocument(Changes what);
  void draw(const Pose& X_WB);
  void showGizmo(const std::optional<GizmoPicture::Held>& held = std::nullopt);
  /// The pose at which an item is drawn.
  std::optional<Pose> shownPose(const AssemblyItem& item) const;
  /// X_WG of the selected item.
  std::optional<Pose> gizmoPose() const;
  QString amountText(const GizmoDrag& drag, const GizmoAmount& amount) const;

  /// The pose that a running edit gives an item.
  struct Put {
    AssemblyItem item;
    Pose X_WB;
  };
  struct InHand {
    AssemblyItem item;
    Pose before;
    Pose now;
    std::variant<PoseDrag, GizmoDrag> drag;
  };

  const WorkbenchDocument& document_;
  GizmoOverlay* gizmo_;
  bool on_ = false;
  bool snapping_ = false;
  ArrangeSnapping& features_;
  GizmoSteps steps_;
  std::optional<ArrangedItem> selected_;
  std::optional<InHand> inHand_;
  std::optional<Put> put_;
};

}  // namespace glissade
