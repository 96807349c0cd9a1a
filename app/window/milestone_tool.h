#pragma once

#include "app/window/drag_tool.h"
#include "widgets/document/workbench_document.h"
#include "widgets/scene3d/milestone_drag.h"

namespace glissade {

/// Lets a person take a shown milestone with the mouse: drag moves it inside its border, Ctrl+drag
/// turns it. One drag is one undoable edit, made when the button goes up.
class MilestoneTool final : public DragTool {
  Q_OBJECT

 public:
  MilestoneTool(WorkbenchDocument& document, SceneWidget& scene, QObject* parent);

  /// The plan whose milestones can be taken; null: none.
  void setPlan(const CoarsePlanPtr& plan);
  /// The plan to draw: with the milestone in hand where the pointer is.
  CoarsePlanPtr shownPlan() const;

 signals:
  /// The milestone in hand was moved, or was dropped.
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
  CoarsePlanPtr gripped_;  ///< the plan that the milestone was taken from
  std::optional<MilestoneDrag> drag_;
};

}  // namespace glissade
