#include "widgets/sequence/sequence_panel.h"

#include <QCoreApplication>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

#include "engine/sequence/plan_playback.h"
#include "engine/sequence/step_cost.h"
#include "engine/sequence/subassembly_lines.h"
#include "widgets/controls/body_id_text.h"
#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/row_search.h"

namespace glissade {
namespace {

/// Places of the slider that plays, which are fine enough for the steps of large products.
constexpr int kPlayPlaces = 100000;
constexpr int kExplodePlaces = 200;
constexpr double kExplodeSeconds = 4.0;
constexpr double kSecondsPerStep = 1.5;
constexpr double kLongestPlay = 90.0;
/// A selected step is shown with the part of its first motion at this share of the motion.
constexpr double kOnTheWay = 0.5;

void onlyIcons(const QLayout& row) {
  for (int i = 0; i < row.count(); ++i) {
    auto* button = qobject_cast<QToolButton*>(row.itemAt(i)->widget());
    if (button == nullptr) continue;
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setMinimumWidth(2 * button->iconSize().width());  // icons are set later
  }
}

}  // namespace

SequencePanel::SequencePanel(const ActionCatalogue& actions, QWidget* parent)
    : QWidget(parent),
      summary_(new QLabel(this)),
      table_(new StepTable([this](const RigidBody& body) { return pictures_.of(body); }, this)),
      play_(new PlaySlider(kPlayPlaces, kLongestPlay, this)),
      explode_(new PlaySlider(kExplodePlaces, kExplodeSeconds, this)),
      place_(new QLabel(this)),
      cost_(new QComboBox(this)),
      edits_(new QMenu(tr("Step"), this)),
      demands_(new QMenu(tr("Co&nstraints"), this)) {
  summary_->setWordWrap(true);
  summary_->setTextFormat(Qt::PlainText);
  summary_->setObjectName(QStringLiteral("sequence-summary"));
  play_->setAccessibleName(tr("Place in the sequence"));
  play_->setToolTip(tr("Place in the sequence"));
  explode_->setAccessibleName(tr("Exploded view"));
  explode_->setToolTip(tr("Moves the parts apart along their directions of removal"));
  addEditing(actions);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(4);
  layout->addLayout(makePlanningRow(actions));
  layout->addWidget(summary_);
  layout->addWidget(table_, 1);
  layout->addLayout(makePlayingRow(actions));
  layout->addLayout(makeExplodingRow());
  connect(&pictures_, &PartPictures::drawn, table_, &StepTable::takeIcons);
  connect(table_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* row) { showRow(row); });
  connect(table_, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* row) { showRow(row); });
  connect(table_, &QTreeWidget::itemSelectionChanged, this, &SequencePanel::selectionChanged);
  connect(table_, &StepTable::stepDragged, this, &SequencePanel::stepMoved);
  connect(play_, &PlaySlider::shareShown, this, [this] {
    markRow();
    emit sceneChanged();
  });
  connect(play_, &PlaySlider::playbackEnded, this, &SequencePanel::playbackEnded);
  connect(explode_, &PlaySlider::shareShown, this, &SequencePanel::sceneChanged);
  setPlan({});
}

/// Fills the menu of edits of a step, which the table and a button show.
void SequencePanel::addEditing(const ActionCatalogue& actions) {
  auto* forbid = new QMenu(tr("Rule out a &direction"), this);
  forbid->addAction(actions["sequence.forbid-way"]);
  for (const char* axis : {"+x", "-x", "+y", "-y", "+z", "-z"}) {
    const QString id = QLatin1String(axis);
    QString text = id.toUpper();
    text.replace(QLatin1Char('-'), QChar(0x2212));
    connect(forbid->addAction(text), &QAction::triggered, this, [this, id] { emit directionForbidden(id); });
  }
  for (const char* id : {"sequence.step-up", "sequence.step-down", "sequence.lock"}) {
    edits_->addAction(actions[QLatin1String(id)]);
  }
  edits_->addMenu(forbid);
  for (const char* id : {"sequence.keep-order", "sequence.free-step"}) edits_->addAction(actions[QLatin1String(id)]);
  edits_->addMenu(demands_);
  edits_->addSeparator();
  for (const char* id : {"sequence.by-hand", "sequence.take-path", "sequence.leave-hand"}) {
    edits_->addAction(actions[QLatin1String(id)]);
  }
  table_->addActions(edits_->actions());
  table_->setContextMenuPolicy(Qt::ActionsContextMenu);
}

QLayout* SequencePanel::makePlanningRow(const ActionCatalogue& actions) {
  auto* row = makeActionFlow(
      actions, {"sequence.plan", "sequence.resume", "sequence.graph", "sequence.open", "sequence.export"}, this);
  onlyIcons(*row);
  qobject_cast<QToolButton*>(row->itemAt(0)->widget())->setToolButtonStyle(Qt::ToolButtonTextOnly);
  auto* step = new QToolButton(this);
  step->setText(tr("Ste&p"));
  step->setToolTip(tr("Move, lock or free the selected step, or move its part by hand"));
  step->setAutoRaise(true);
  step->setFocusPolicy(Qt::TabFocus);
  step->setPopupMode(QToolButton::InstantPopup);
  step->setMenu(edits_);
  step->setMinimumWidth(step->sizeHint().width() + step->iconSize().width());
  row->addWidget(step);
  return row;
}

QLayout* SequencePanel::makePlayingRow(const ActionCatalogue& actions) {
  auto* row = makeActionRow(actions, {"sequence.play", "sequence.assembly-order", "sequence.aside"}, this);
  onlyIcons(*row);
  row->insertWidget(1, play_, 1);
  row->insertWidget(2, place_);
  return row;
}

QLayout* SequencePanel::makeExplodingRow() {
  auto* row = new QHBoxLayout;
  auto* title = new QLabel(tr("E&xplode"), this);
  title->setBuddy(explode_);
  row->addWidget(title);
  row->addWidget(explode_, 1);
  auto* order = new QLabel(tr("&Cost"), this);
  order->setBuddy(cost_);
  row->addWidget(order);
  cost_->setEditable(true);
  cost_->setInsertPolicy(QComboBox::NoInsert);
  cost_->setAccessibleName(tr("What a step costs"));
  cost_->setToolTip(
      tr("The order that costs least is used. An expression, as 5 * tool_change + length, or one of the list; the last "
         "of it keeps the order in which the removals were found"));
  for (const StepCostPreset& preset : stepCostPresets()) {
    const QString id = QString::fromStdString(preset.id);
    const QString shown = engineText(preset.label);
    cost_->addItem(shown, cost_->count() == 0 ? QString() : id);  // the first one is the default
    cost_->setItemData(cost_->count() - 1, QString::fromStdString(preset.expression), Qt::ToolTipRole);
  }
  cost_->setMinimumContentsLength(10);
  cost_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  row->addWidget(cost_);
  connect(cost_, qOverload<int>(&QComboBox::activated), this, &SequencePanel::chooseCost);
  connect(cost_->lineEdit(), &QLineEdit::editingFinished, this, &SequencePanel::chooseCost);
  return row;
}

void SequencePanel::chooseCost() {
  const int known = cost_->findText(cost_->currentText());
  const QString cost = known >= 0 ? cost_->itemData(known).toString() : cost_->currentText().trimmed();
  emit costChosen(cost);
}

void SequencePanel::setCost(const std::string& cost) {
  const QSignalBlocker block(cost_);
  const QString text = QString::fromStdString(cost);
  const int known = cost_->findData(text);
  if (known >= 0) {
    cost_->setCurrentIndex(known);
  } else {
    cost_->setEditText(text);
  }
}

void SequencePanel::setPlan(const ShownPlan& shown) {
  const double before = time();
  const bool samePlan = shown_.plan && shown.plan && shown_.product == shown.product;
  const auto chosen = chosenStep();
  shown_ = shown;
  if (!shown.growing) tried_.clear();
  const std::size_t steps = shown.plan ? shown.plan->steps.size() : 0;
  if (shown.product && shown.plan) pictures_.draw(shown.product, table_->iconSize().width(), atOnce_);
  table_->show(shown, order_);
  summary_->setText(summary());
  play_->setEnabled(steps > 0);
  explode_->setEnabled(steps > 0);
  play_->setSeconds(std::min(kLongestPlay, kSecondsPerStep * static_cast<double>(std::max<std::size_t>(4, steps))));
  if (!samePlan || steps == 0) {
    const QSignalBlocker block(explode_);
    explode_->setValue(0);
  }
  showTime(samePlan ? std::min(before, static_cast<double>(steps)) : 0.0);
  if (!shown.growing && !chosen) table_->scrollToTop();
  if (samePlan && chosen && table_->currentItem() == nullptr) chooseStep(std::min(*chosen, steps - 1));
  emit selectionChanged();
}

/// The number of parts that have a step, how many of them stay in groups, and the certified motions.
QString SequencePanel::leaving(const AssemblyPlan& plan) const {
  const auto removed = static_cast<int>(plan.removed());
  const auto open = static_cast<int>(plan.removedWithoutProof());
  const auto joined = static_cast<int>(plan.removed() - bodiesApart(plan));
  QStringList facts{(order_ == PlanOrder::Assembly ? tr("%n of %1 parts assembled", "", removed)
                                                   : tr("%n of %1 parts removed", "", removed))
                        .arg(plan.parts())};
  if (joined > 0) facts << tr("%n of them in groups that stay together", "", joined);
  if (removed > 0) {
    facts << (open == 0 ? tr("every motion certified") : tr("%n without a certificate", "", open));
  }
  return facts.join(QStringLiteral(", ")) + QLatin1Char('.');
}

QString SequencePanel::stuckText(const AssemblyPlan& plan) {
  if (plan.end != PlanEnd::Stuck || plan.parts() == 0) return {};
  return QLatin1Char(' ') + tr("%n stuck.", "", static_cast<int>(plan.parts() - plan.removed()));
}

QString SequencePanel::resultText() const {
  return shown_.plan ? leaving(*shown_.plan) + stuckText(*shown_.plan) : QString();
}

/// The base, and the bodies that stay with it because they are bonded to it.
QString SequencePanel::baseText() const {
  std::vector<BodyId> base = shown_.plan->staying;
  QStringList held;
  for (const HeldByBase& each : shown_.held) {
    std::erase(base, each.body);
    const QString body = table_->nameOf(each.body);
    const QString with = table_->nameOf(each.with);
    if (each.kind == JointKind::Insert) {
      held << tr("%1 (pressed into %2)").arg(body, with);
    } else if (each.kind == JointKind::Permanent) {
      held << tr("%1 (permanent joint with %2)").arg(body, with);
    } else {
      held << tr("%1 (one unit with %2)").arg(body, with);
    }
  }
  QString text = tr("Base: %1.").arg(table_->shortNames(base));
  if (!held.isEmpty()) text += QLatin1Char(' ') + tr("Stays with it: %1.").arg(held.join(QStringLiteral(", ")));
  return text;
}

/// The parts that are tried at present.
QString SequencePanel::planningText() const {
  constexpr std::size_t kNamed = 2;
  if (shown_.isWaiting) return tr("Constraints have changed: planning begins when you pause, or now by Plan sequence.");
  if (tried_.empty()) return tr("Planning…");
  const std::size_t named = std::min(kNamed, tried_.size());
  const QString names = table_->shortNames({tried_.begin(), tried_.begin() + static_cast<std::ptrdiff_t>(named)});
  const auto more = static_cast<int>(tried_.size() - named);
  return more == 0 ? tr("Trying %1…").arg(names) : tr("Trying %1 and %n more…", "", more).arg(names);
}

void SequencePanel::setTried(const std::vector<BodyId>& bodies) {
  if (!shown_.growing) return;
  tried_ = bodies;
  summary_->setText(summary());
}

QString SequencePanel::summary() const {
  if (!shown_.product) return tr("No product is open.");
  if (!shown_.plan) return tr("Not planned yet.");
  const AssemblyPlan& plan = *shown_.plan;
  QString text = leaving(plan);
  if (!plan.staying.empty()) text += QLatin1Char(' ') + baseText();
  if (shown_.growing) return text + QLatin1Char(' ') + planningText();
  switch (plan.end) {
    case PlanEnd::Complete: break;
    case PlanEnd::Stuck: text += stuckText(plan); break;
    case PlanEnd::TimeLimit: text += QLatin1Char(' ') + tr("The time limit was reached."); break;
    case PlanEnd::Interrupted: text += QLatin1Char(' ') + tr("Stopped. Results kept."); break;
  }
  const auto forced = std::count_if(plan.steps.begin(), plan.steps.end(),
                                    [](const AssemblyStep& step) { return !step.violates.empty(); });
  if (forced > 0) text += QLatin1Char(' ') + tr("%n forced.", "", static_cast<int>(forced));
  const QString isolated = QString::fromStdString(windowPlanWords().isolated(plan, *shown_.product));
  if (!isolated.isEmpty()) text += QLatin1Char(' ') + isolated;
  const auto& checks = shown_.check.steps;
  const auto refuted = std::count(checks.begin(), checks.end(), StepCheck::Disagrees);
  if (refuted > 0) text += QLatin1Char(' ') + tr("%n step(s) are no longer valid.", "", static_cast<int>(refuted));
  for (const Message& condition : shown_.check.conditions) {
    text += QLatin1Char(' ') + tr("Valid only if %1.").arg(engineText(condition));
  }
  return text;
}

void SequencePanel::setOrder(PlanOrder order) {
  if (order == order_) return;
  const double shown = time();
  order_ = order;
  setPlan(shown_);
  showTime(shown);
}

double SequencePanel::timeAt(double share) const {
  const double steps = shown_.plan ? static_cast<double>(shown_.plan->steps.size()) : 0.0;
  return steps * (order_ == PlanOrder::Assembly ? 1.0 - share : share);
}

void SequencePanel::showTime(double time) {
  const double steps = shown_.plan ? static_cast<double>(shown_.plan->steps.size()) : 0.0;
  const double share = steps > 0.0 ? time / steps : 0.0;
  play_->showAt(order_ == PlanOrder::Assembly ? 1.0 - share : share);
}

int SequencePanel::shownRow() const {
  const double steps = shown_.plan ? static_cast<double>(shown_.plan->steps.size()) : 0.0;
  const double done = order_ == PlanOrder::Assembly ? steps - time() : time();
  return static_cast<int>(std::ceil(done - 1e-3)) - 1;
}

void SequencePanel::stepBy(int rows) {
  const QTreeWidgetItem* row = table_->topLevelItem(std::max(0, shownRow() + rows));
  if (const auto step = StepTable::stepOf(row)) chooseStep(*step);
}

QString SequencePanel::placeText() const {
  const int steps = shown_.plan ? static_cast<int>(shown_.plan->steps.size()) : 0;
  if (steps == 0) return {};
  const int row = shownRow();
  const auto step = row < 0 ? std::nullopt : StepTable::stepOf(table_->topLevelItem(row));
  if (!step) return tr("Sequence: %n step(s)", "", steps);
  return tr("Step %1 of %2: %3").arg(row + 1).arg(steps).arg(partsText(*step));
}

/// Shows the place of the slider, such as "3 / 17", and makes its row the current one.
void SequencePanel::markRow() {
  const std::size_t steps = shown_.plan ? shown_.plan->steps.size() : 0;
  const int current = shownRow();
  place_->setText(QStringLiteral("%1 / %2").arg(current + 1).arg(steps));
  // A stuck part is shown when all removable parts have left.
  if (!chosenStuck().empty() && time() > static_cast<double>(steps) - 1e-3) return;
  if (current < 0 || current >= table_->topLevelItemCount()) return;
  const auto before = selectedSteps();
  {
    const QSignalBlocker block(table_);
    table_->setCurrentItem(table_->topLevelItem(current));
  }
  if (selectedSteps() != before) emit selectionChanged();
}

void SequencePanel::showRow(const QTreeWidgetItem* row) {
  if (row == nullptr) return;
  if (const auto step = chosenStep()) {
    showTime(PlayedMotion{*step, 0, kOnTheWay}.time(*shown_.plan));
    emit stepChosen(static_cast<int>(*step));
  } else {
    emit stuckChosen(toQString(chosenStuck()));
  }
}

bool SequencePanel::chooseStep(std::size_t step) {
  QTreeWidgetItem* row = table_->rowOf(step);
  if (row == nullptr) return false;
  {
    const QSignalBlocker block(table_);
    table_->setCurrentItem(row);
  }
  showRow(row);
  emit selectionChanged();
  return true;
}

BodyId SequencePanel::chosenBody() const {
  const auto step = chosenStep();
  return step ? shown_.plan->steps[*step].motions.front().body : chosenStuck();
}

void SequencePanel::chooseBody(const BodyId& id) {
  if (id.empty() || !shown_.plan) return;
  const auto& steps = shown_.plan->steps;
  for (std::size_t step = 0; step < steps.size(); ++step) {
    const auto bodies = steps[step].bodies();
    if (std::find(bodies.begin(), bodies.end(), id) == bodies.end()) continue;
    chooseStep(step);
    return;
  }
  for (int i = 0; i < table_->topLevelItemCount(); ++i) {
    if (StepTable::stuckOf(table_->topLevelItem(i)) == id) table_->setCurrentItem(table_->topLevelItem(i));
  }
}

void SequencePanel::showBodies(const QSet<QString>& ids) {
  const auto isAbout = [&](const QTreeWidgetItem& row) {
    const auto step = StepTable::stepOf(&row);
    const auto bodies = step ? shown_.plan->steps[*step].bodies() : std::vector<BodyId>{StepTable::stuckOf(&row)};
    return std::any_of(bodies.begin(), bodies.end(), [&ids](const BodyId& id) { return ids.contains(toQString(id)); });
  };
  if (goToRow(*table_, isAbout)) emit selectionChanged();
}

bool SequencePanel::selectSteps(const std::vector<std::size_t>& steps) {
  const QSignalBlocker block(table_);
  table_->clearSelection();
  for (const std::size_t step : steps) {
    QTreeWidgetItem* row = table_->rowOf(step);
    if (row == nullptr) return false;
    if (step == steps.front()) table_->setCurrentItem(row);
    row->setSelected(true);
  }
  emit selectionChanged();
  return true;
}

void SequencePanel::setPlaying(bool playing) { play_->setPlaying(playing); }

}  // namespace glissade
