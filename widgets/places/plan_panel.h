#pragma once

#include <QLabel>
#include <QTreeWidget>

#include "engine/planning/coarse/coarse_plan.h"
#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The topological steps of the coarse plan: the selected planner with the reason, its costs, and its result. A click
/// shows the step in the scene.
class PlanPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit PlanPanel(const ActionCatalogue& actions, QWidget* parent = nullptr);

  /// Shows the plan. The current step stays current if the new plan has it. Null: there is no plan; `whyNone` gives the
  /// reason, if known.
  void setPlan(const CoarsePlanPtr& plan, const QString& whyNone = {});
  /// The current step; nothing: none.
  std::optional<std::size_t> currentStep() const;
  /// Leaves no step current.
  void leaveStep();

 signals:
  /// A step was selected, possibly the same one again, or none any more.
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
