#include "widgets/panels/plan_panel.h"

#include <QHeaderView>
#include <QLocale>
#include <QVBoxLayout>

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

}  // namespace

PlanPanel::PlanPanel(const ActionCatalogue& actions, QWidget* parent)
    : QWidget(parent), summary_(new QLabel(this)), steps_(new QTreeWidget(this)), why_(new QLabel(this)) {
  steps_->setObjectName(QStringLiteral("steps"));
  steps_->setColumnCount(5);
  steps_->setHeaderLabels({tr("Place"), tr("To"), tr("Planner"), tr("Random"), tr("Result")});
  steps_->headerItem()->setToolTip(3, tr("Random configurations, milestone and local planner together"));
  steps_->setRootIsDecorated(false);
  steps_->setUniformRowHeights(true);
  steps_->setAlternatingRowColors(true);
  for (int column = 0; column < 5; ++column) {
    steps_->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  }
  steps_->header()->setStretchLastSection(true);
  steps_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  steps_->setMinimumSize(288, 64);
  why_->setWordWrap(true);
  summary_->setWordWrap(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(4);
  layout->addWidget(summary_);
  layout->addWidget(steps_, 1);
  layout->addWidget(why_);
  layout->addLayout(makeActionRow(actions, {"place.forbid", "place.prefer", "milestone.set", "milestone.reset"}, this));
  connect(steps_, &QTreeWidget::itemSelectionChanged, this, [this] {
    const auto step = currentStep();
    why_->setText(step ? QString::fromStdString(plan_->steps[*step].why) : QString());
    emit stepChosen();
  });
  setPlan(nullptr);
}

std::optional<std::size_t> PlanPanel::currentStep() const {
  const auto selected = steps_->selectedItems();
  if (selected.isEmpty() || !plan_) return std::nullopt;
  const auto index = static_cast<std::size_t>(steps_->indexOfTopLevelItem(selected.front()));
  return index < plan_->steps.size() ? std::optional<std::size_t>(index) : std::nullopt;
}

void PlanPanel::setPlan(const CoarsePlanPtr& plan) {
  if (plan == plan_ && plan != nullptr) return;
  plan_ = plan;
  if (!plan_) {
    steps_->clear();
    why_->clear();
    summary_->setText(tr("No coarse plan: choose strategy GT or GTS and start."));
    return;
  }
  const QLocale locale;
  if (plan_->attempt == 0) {
    summary_->setText(tr("Coarse path of cost %1, not tried yet").arg(locale.toString(plan_->cost, 'f', 2)));
  } else {
    summary_->setText(tr("Coarse path %1, cost %2; random configurations: coarse %3, fine %4")
                          .arg(plan_->attempt)
                          .arg(locale.toString(plan_->cost, 'f', 2))
                          .arg(locale.toString(static_cast<qulonglong>(plan_->coarseConfigurations)),
                               locale.toString(static_cast<qulonglong>(plan_->fineConfigurations))));
  }
  while (steps_->topLevelItemCount() > static_cast<int>(plan_->steps.size())) {
    delete steps_->takeTopLevelItem(steps_->topLevelItemCount() - 1);
  }
  for (std::size_t i = 0; i < plan_->steps.size(); ++i) showStep(i);
  const auto step = currentStep();
  why_->setText(step ? QString::fromStdString(plan_->steps[*step].why) : QString());
}

void PlanPanel::showStep(std::size_t index) {
  const TopologicalStep& step = plan_->steps[index];
  QTreeWidgetItem* item = steps_->topLevelItem(static_cast<int>(index));
  if (item == nullptr) item = new QTreeWidgetItem(steps_);
  item->setText(0, QString::fromStdString(step.placeName));
  item->setText(1, QString::fromStdString(step.borderName));
  item->setText(2, (step.geometrical ? QStringLiteral("A*, ") : QString()) + QString::fromStdString(step.planner));
  item->setText(3, QLocale().toString(static_cast<qulonglong>(step.randomConfigurations)));
  item->setTextAlignment(3, Qt::AlignRight | Qt::AlignVCenter);
  item->setText(4, resultText(step.result));
  for (int column = 0; column < 5; ++column) item->setToolTip(column, QString::fromStdString(step.why));
}

}  // namespace glissade
