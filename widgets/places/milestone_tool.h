#pragma once

#include "widgets/document/workbench_document.h"
#include "widgets/scene3d/milestone_drag.h"
#include "widgets/workbench/drag_tool.h"

namespace glissade {

/// Lets a person move a milestone with the mouse: a drag moves it inside its border, Ctrl+drag turns it. Each drag is
/// one undoable edit, made at the release.
class MilestoneTool final : public DragTool {
  Q_OBJECT

 public:
  MilestoneTool(WorkbenchDocument& document, SceneWidget& scene, QObject* parent);

  /// Sets the plan whose milestones can be moved; null: none.
  void setPlan(const CoarsePlanPtr& plan);
  /// The plan to draw; the milestone in hand is at the pointer.
  CoarsePlanPtr shownPlan() const;

 signals:
  /// The milestone in hand was moved or dropped.
  void moved();
  void refused(const glissade::Diagnostic& why);

 private:
  bool grip(const QPointF& position) override;
  bool holds() const override { return drag_.has_value(); }
  void moveTo(const QPointF& position) override;
  void turn(const QPointF& position, const QPointF& by) override;
  void drop() override;

  WorkbenchDocument& document_;
  CoarsePlanPtr plan_;
  CoarsePlanPtr gripped_;  ///< the plan of the gripped milestone
  std::optional<MilestoneDrag> drag_;
};

}  // namespace glissade
