#pragma once

#include <QLabel>
#include <QTreeWidget>

#include "engine/planning/coarse/coarse_plan.h"
#include "widgets/commands/action_catalogue.h"

namespace glissade {

/// The topological steps of the coarse plan: which planner was chosen and why, what it has spent, what
/// became of it. A click shows the step in the scene.
class PlanPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit PlanPanel(const ActionCatalogue& actions, QWidget* parent = nullptr);

  /// The step that was looked at stays so where the plan has it still. Null: none, with the reason where there is
  /// one to tell.
  void setPlan(const CoarsePlanPtr& plan, const QString& whyNone = {});
  /// The step that is looked at; nothing: none.
  std::optional<std::size_t> currentStep() const;
  /// No step is looked at any more.
  void leaveStep();

 signals:
  /// A step was chosen, perhaps the same again, or none any more.
  void stepChosen();

 private:
  void showSummary();
  void showStep(std::size_t index);
  void showWhy();

  CoarsePlanPtr plan_;
  QLabel* summary_;
  QTreeWidget* steps_;
  QLabel* why_;
};

}  // namespace glissade
