#pragma once

#include <QPointF>

#include "widgets/document/knowledge_builder.h"
#include "widgets/places/milestone_tool.h"
#include "widgets/places/plan_panel.h"
#include "widgets/places/semantics_panel.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// Builds the environment model of the document, shows it with its semantic attributes and the coarse plan, and edits
/// places and milestones.
class EnvironmentController final : public QObject {
  Q_OBJECT

 public:
  explicit EnvironmentController(const Workbench& bench);

  SemanticsPanel* semanticsPanel() const { return semantics_; }
  PlanPanel* planPanel() const { return plan_; }
  /// Builds the model again with another method that finds places; `identifier`: id in the registry of place
  /// identifiers.
  void identifyPlaces(const std::string& identifier);
  /// The coarse plan that is shown; null if there is none.
  const CoarsePlanPtr& shownPlan() const { return shownPlan_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// The input of the last environment model.
  struct ModelledScene {
    std::vector<RigidBody> obstacles;
    RigidBody object;
    Box3 workspace;
    std::map<std::string, AttributeValue> mobility;  ///< by rigid body, as the user has set it
  };

  void connectActions();
  void followDocument(Changes what);
  void followRun(const SnapshotPtr& snapshot);
  void startScenario();
  void updateModel(Changes what);
  /// Builds the environment model and reuses the unchanged parts of `before`, which may be null.
  void build(const SceneKnowledgePtr& before);
  bool isModelled(const LoadedScenario& scenario) const;
  /// Selects the item at a point of the scene widget; `add`: adds it to the selection.
  void pick(const QPointF& position, bool add);
  void showEnvironment();
  void showPlan();
  void takePlan(const CoarsePlanPtr& plan, const QString& whyNone = {});
  void drawPlan();
  void showStep();
  void leaveStep();
  void toggleForbidden();
  void togglePreferred();
  /// Sets the attribute on the selected places, or resets it if all of them have it.
  void toggle(const std::string& attribute, const AttributeValue& value, bool (*isSet)(const AttributeValue&));
  void setMilestone(bool here);
  void changeCellLevel(int by);
  void enableActions();
  void showError(const Diagnostic& why);
  void refuseMilestone(const Diagnostic& why);

  const Workbench& bench_;
  SemanticDocument& document_;
  MilestoneTool milestones_;
  KnowledgeBuilder builder_;
  SemanticsPanel* semantics_;
  PlanPanel* plan_;
  ModelledScene modelled_;
  int finestCellLevel_ = 6;
  SnapshotPtr snapshot_;  ///< the snapshot shown last
  CoarsePlanPtr shownPlan_;
  QPointF pressed_;
  BackgroundTask preview_;  ///< last member, because it waits for its threads before the others are destroyed
};

}  // namespace glissade
