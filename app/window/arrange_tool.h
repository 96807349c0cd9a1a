#pragma once

#include <QKeyEvent>

#include <variant>

#include "app/window/arrange_snapping.h"
#include "app/window/drag_tool.h"
#include "widgets/document/workbench_document.h"
#include "widgets/scene3d/gizmo_overlay.h"
#include "widgets/scene3d/pose_drag.h"

namespace glissade {

/// What is arranged, and where its gizmo is.
struct ArrangedItem {
  AssemblyItem item;
  Pose X_BG;             ///< in the frame that its pose is of
  bool ownAxes = false;  ///< the gizmo has the axes of X_BG; else those of the world
};

/// While it is on, a person moves bodies, and the object's ghosts at its start and its goal. A gizmo at what is
/// selected moves it along its axes and turns it about them, by the pointer or by keys. A body that is taken itself
/// moves in the plane of the view, and turns about its axes. Bodies and ghosts are only drawn elsewhere until they are
/// dropped.
class ArrangeTool final : public DragTool {
  Q_OBJECT

 public:
  ArrangeTool(const WorkbenchDocument& document, SceneWidget& scene, ArrangeSnapping& features, QObject* parent);

  void setOn(bool on);
  /// What is selected has the gizmo, and is gripped also behind other bodies.
  void setSelected(const std::optional<ArrangedItem>& selected);
  /// Amounts are rounded to the steps. Ctrl suspends that, and the snapping to features; where both are off, it rounds.
  void setSnapping(bool snapping, const GizmoSteps& steps);

  const GizmoOverlay& gizmo() const { return *gizmo_; }

 signals:
  /// What is dragged meets this now; empty: nothing.
  void snapped(const QString& what);
  void gripped(const glissade::AssemblyItem& item);
  void dropped(const glissade::AssemblyItem& item, const glissade::Pose& X_WB);
  /// A key has put it there.
  void nudged(const glissade::AssemblyItem& item, const glissade::Pose& X_WB);
  /// Esc, while nothing is held.
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
  /// Puts back what is held.
  void letGo();
  bool pressKey(const QKeyEvent& event);
  void nudge(int viewAxis, double sign, bool turning);
  void hover(const QPointF& position);
  void followDocument(Changes what);
  void draw(const Pose& X_WB);
  void showGizmo(const std::optional<GizmoPicture::Held>& held = std::nullopt);
  /// Where an item is drawn.
  std::optional<Pose> shownPose(const AssemblyItem& item) const;
  /// X_WG of what is selected.
  std::optional<Pose> gizmoPose() const;
  QString amountText(const GizmoDrag& drag, const GizmoAmount& amount) const;

  /// Where something was put by an edit that is under way.
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
