#pragma once

#include <QObject>
#include <QPointF>

#include "widgets/bridge/session_bridge.h"
#include "widgets/model/semantic_document.h"
#include "widgets/scene3d/milestone_drag.h"
#include "widgets/scene3d/scene_widget.h"

namespace glissade {

/// Lets a person take a shown milestone with the mouse: drag moves it inside its border, Ctrl+drag
/// turns it. One drag is one undoable edit, made when the button goes up.
class MilestoneTool final : public QObject {
  Q_OBJECT

 public:
  MilestoneTool(SemanticDocument& document, SceneWidget& scene, QObject* parent);

  void setScenario(const ScenarioPtr& scenario);
  /// The plan whose milestones can be taken; null: none.
  void setPlan(const CoarsePlanPtr& plan);
  /// The plan to draw: with the milestone in hand where the pointer is.
  CoarsePlanPtr shownPlan() const;

 signals:
  void moving();
  void refused(const glissade::Diagnostic& why);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool grip(const QPointF& position);
  void follow(const QPointF& position, bool turning);
  void drop();

  SemanticDocument& document_;
  SceneWidget& scene_;
  ScenarioPtr scenario_;
  CoarsePlanPtr plan_;
  CoarsePlanPtr gripped_;  ///< the plan that the milestone was taken from
  std::optional<MilestoneDrag> drag_;
  QPointF last_;
};

}  // namespace glissade
