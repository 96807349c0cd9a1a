#pragma once

#include <QObject>
#include <QPointF>

#include "app/window/milestone_tool.h"
#include "widgets/bridge/knowledge_builder.h"
#include "widgets/bridge/session_bridge.h"
#include "widgets/commands/action_catalogue.h"
#include "widgets/editors/semantics_panel.h"
#include "widgets/model/semantic_document.h"
#include "widgets/panels/plan_panel.h"
#include "widgets/scene3d/scene_widget.h"

namespace glissade {

/// Keeps the environment model, its semantic attributes, the coarse plan, the panels and the scene in
/// step with each other and with the session. Part of the main window.
class EnvironmentController final : public QObject {
  Q_OBJECT

 public:
  EnvironmentController(SessionBridge& bridge, const ActionCatalogue& actions, SceneWidget& scene, QWidget* window);
  ~EnvironmentController() override;

  SemanticDocument& document() { return document_; }
  SemanticsPanel* semanticsPanel() const { return semantics_; }
  PlanPanel* planPanel() const { return plan_; }

  void open(const ScenarioPtr& scenario);
  /// The same scenario with its bodies elsewhere, or others; the document has it already.
  void rearrange(const ScenarioPtr& scenario);
  void showSnapshot(const SnapshotPtr& snapshot);
  /// Builds the environment model; what stays of `before` (may be null) is not built again.
  void build(const SceneKnowledgePtr& before);
  /// Builds it anew with another way to find places; an id of the place identifier registry.
  void identifyPlaces(const std::string& identifier);
  /// How the environment is modelled: the scenario's, until somebody chooses otherwise.
  const EnvironmentOptions& options() const { return options_; }
  /// The plan that is shown; null where there is none.
  const CoarsePlanPtr& shownPlan() const { return shownPlan_; }
  /// Selects what lies under a point of the scene widget; `add`: besides what is selected.
  void pick(const QPointF& position, bool add);

 signals:
  void failed(const glissade::Diagnostic& why);
  /// The scenario is about places: their panels should be seen.
  void wanted();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void connectActions();
  void knowledgeReady(const SceneKnowledgePtr& knowledge);
  void documentChanged();
  void showEnvironment();
  void showPlan();
  void drawPlan();
  void showStep();
  void leaveStep();
  void toggleForbidden();
  void togglePreferred();
  void setMilestone(bool here);
  void changeCellLevel(int by);
  void enableActions();

  SessionBridge& bridge_;
  const ActionCatalogue& actions_;
  SceneWidget& scene_;
  SemanticDocument document_;
  MilestoneTool milestones_;
  KnowledgeBuilder builder_;
  SemanticsPanel* semantics_;
  PlanPanel* plan_;
  ScenarioPtr scenario_;
  EnvironmentOptions options_;
  int finestCellLevel_ = 6;
  SnapshotPtr snapshot_;
  CoarsePlanPtr shownPlan_;
  std::map<std::string, AttributeValue> builtMobility_;
  QPointF pressed_;
};

}  // namespace glissade
