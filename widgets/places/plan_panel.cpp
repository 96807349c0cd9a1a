#include "widgets/places/plan_panel.h"

#include <QHeaderView>
#include <QLocale>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "engine/planning/coarse/topological_planner.h"
#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/length_text.h"

namespace glissade {
namespace {

QString resultText(StepResult result) {
  switch (result) {
    case StepResult::Pending: return PlanPanel::tr("to do");
    case StepResult::Running: return PlanPanel::tr("running");
    case StepResult::Solved: return PlanPanel::tr("solved");
    case StepResult::Failed: return PlanPanel::tr("failed");
  }
  return {};
}

QString listed(const std::vector<std::string>& names) {
  QStringList list;
  for (const std::string& name : names) list << QString::fromStdString(name);
  return list.join(QStringLiteral(", "));
}

QString noWayText(const CoarsePlan& plan) {
  QStringList sentences{PlanPanel::tr("No path through the places.")};
  if (!plan.forbidden.empty()) sentences << PlanPanel::tr("Forbidden: %1.").arg(listed(plan.forbidden));
  if (!plan.infiniteCost.empty()) sentences << PlanPanel::tr("Of infinite cost: %1.").arg(listed(plan.infiniteCost));
  if (sentences.size() == 1) sentences << PlanPanel::tr("None leads from start to goal.");
  return sentences.join(QLatin1Char(' '));
}

bool solvedAsAWhole(const CoarsePlan& plan) {
  return !plan.steps.empty() && plan.steps.back().place == TopologicalStep::kWholeWorkspace &&
         plan.steps.back().result == StepResult::Solved;
}

/// The step of another plan that crosses the same place to the same border, or else a step through the same place.
std::optional<std::size_t> sameStep(const CoarsePlan& before, const TopologicalStep& step, const CoarsePlan& plan) {
  if (!samePlaces(before.basis.environment, plan.basis.environment)) return std::nullopt;
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    if (plan.steps[i].place != step.place) continue;
    if (plan.steps[i].border == step.border) return i;
    if (!found) found = i;
  }
  return found;
}

}  // namespace

PlanPanel::PlanPanel(const ActionCatalogue& actions, QWidget* parent)
    : QWidget(parent), summary_(new QLabel(this)), steps_(new QTreeWidget(this)), why_(new QLabel(this)) {
  steps_->setObjectName(QStringLiteral("steps"));
  steps_->setAccessibleName(tr("Steps of the coarse path"));
  steps_->setColumnCount(5);
  steps_->setHeaderLabels({tr("Place"), tr("To"), tr("Planner"), tr("Random"), tr("Result")});
  steps_->headerItem()->setToolTip(3, tr("Random configurations, milestone and local planner together"));
  steps_->setRootIsDecorated(false);
  steps_->setUniformRowHeights(true);
  steps_->setAlternatingRowColors(true);
  for (int column = 0; column < 5; ++column) {
    steps_->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  }
  // The planner's name is cut if there is little room; a tool tip shows it in full.
  steps_->header()->setStretchLastSection(false);
  steps_->header()->setSectionResizeMode(2, QHeaderView::Stretch);
  steps_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  steps_->setMinimumSize(200, 64);
  why_->setTextFormat(Qt::PlainText);
  why_->setWordWrap(true);
  summary_->setTextFormat(Qt::PlainText);
  summary_->setWordWrap(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(4);
  layout->addWidget(summary_);
  layout->addWidget(steps_, 1);
  layout->addWidget(why_);
  layout->addLayout(
      makeActionFlow(actions, {"place.forbid", "place.prefer", "milestone.set", "milestone.reset"}, this));
  connect(steps_, &QTreeWidget::itemSelectionChanged, this, [this] {
    showWhy();
    emit stepChosen();
  });
  // A press on the current row counts, too: its place may have been deselected.
  connect(steps_, &QTreeWidget::itemPressed, this, [this] { emit stepChosen(); });
  setPlan(nullptr);
}

std::optional<std::size_t> PlanPanel::currentStep() const {
  const auto selected = steps_->selectedItems();
  if (selected.isEmpty() || !plan_) return std::nullopt;
  const auto index = static_cast<std::size_t>(steps_->indexOfTopLevelItem(selected.front()));
  return index < plan_->steps.size() ? std::optional<std::size_t>(index) : std::nullopt;
}

void PlanPanel::leaveStep() { steps_->clearSelection(); }

void PlanPanel::setPlan(const CoarsePlanPtr& plan, const QString& whyNone) {
  if (plan == plan_ && plan != nullptr) return;
  const auto step = currentStep();
  const auto stays = step && plan ? sameStep(*plan_, plan_->steps[*step], *plan) : std::nullopt;
  // Rows are reused: the current row follows its step, without a signal.
  const QSignalBlocker quiet(steps_);
  plan_ = plan;
  const std::size_t rows = plan_ ? plan_->steps.size() : 0;
  while (steps_->topLevelItemCount() > static_cast<int>(rows)) {
    delete steps_->takeTopLevelItem(steps_->topLevelItemCount() - 1);
  }
  for (std::size_t i = 0; i < rows; ++i) showStep(i);
  if (stays != currentStep()) {
    steps_->setCurrentItem(stays ? steps_->topLevelItem(static_cast<int>(*stays)) : nullptr);
    if (!stays) steps_->clearSelection();
  }
  showWhy();
  if (plan_) {
    showSummary();
  } else {
    summary_->setText(whyNone.isEmpty() ? tr("No coarse plan: choose the strategy Layers and start.") : whyNone);
  }
}

void PlanPanel::showSummary() {
  const QLocale locale;
  const QString cost = locale.toString(plan_->cost, 'f', 2);
  QString summary;
  if (solvedAsAWhole(*plan_)) {
    summary = tr("Solved by the search of the whole workspace, after %1 coarse paths; random configurations: %2")
                  .arg(countText(plan_->attempt), countText(plan_->coarseConfigurations + plan_->fineConfigurations));
  } else if (plan_->nodes.empty()) {
    summary = noWayText(*plan_);
  } else if (plan_->attempt == 0) {
    summary = tr("Coarse path of cost %1, not tried yet").arg(cost);
  } else {
    summary = tr("Coarse path %1, cost %2; random configurations: coarse %3, fine %4")
                  .arg(countText(plan_->attempt), cost, countText(plan_->coarseConfigurations),
                       countText(plan_->fineConfigurations));
  }
  summary_->setText(summary);
}

void PlanPanel::showWhy() {
  const auto step = currentStep();
  why_->setText(step ? engineText(plan_->steps[*step].why) : QString());
}

void PlanPanel::showStep(std::size_t index) {
  const TopologicalStep& step = plan_->steps[index];
  QTreeWidgetItem* item = steps_->topLevelItem(static_cast<int>(index));
  if (item == nullptr) item = new QTreeWidgetItem(steps_);
  const bool whole = step.place == TopologicalStep::kWholeWorkspace;
  item->setText(0, whole ? tr("everywhere") : QString::fromStdString(step.placeName));
  item->setText(1, QString::fromStdString(step.borderName));
  item->setText(2, (step.geometrical ? QStringLiteral("A*, ") : QString()) + QString::fromStdString(step.planner));
  item->setText(3, countText(step.randomConfigurations));
  item->setTextAlignment(3, Qt::AlignRight | Qt::AlignVCenter);
  item->setText(4, resultText(step.result));
  for (int column = 0; column < 5; ++column) item->setToolTip(column, engineText(step.why));
}

}  // namespace glissade
