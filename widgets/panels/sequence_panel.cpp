#include "widgets/panels/sequence_panel.h"

#include <QHeaderView>
#include <QLocale>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

#include "widgets/commands/length_text.h"

namespace glissade {
namespace {

enum SequenceColumn {
  Number,
  PartName,
  Motion,
  LeastClearance,
  LargestAllowance,
  Tool,
  Standing,
  Seconds,
  State,
  SequenceColumns
};

constexpr int kStepRole = Qt::UserRole;       // counted in the plan
constexpr int kStuckRole = Qt::UserRole + 1;  // id of a stuck part
constexpr int kPartWidth = 110;
constexpr int kMotionWidth = 150;
/// Of the slider that plays: fine enough for the steps of large products.
constexpr int kPlayPlaces = 100000;
constexpr int kExplodePlaces = 200;
constexpr double kExplodeSeconds = 4.0;
constexpr double kSecondsPerStep = 1.5;
constexpr double kLongestPlay = 90.0;
/// A step that is chosen is shown with its part on the way.
constexpr double kOnTheWay = 0.5;

void onlyIcons(const QHBoxLayout& row) {
  for (int i = 0; i < row.count(); ++i) {
    auto* button = qobject_cast<QToolButton*>(row.itemAt(i)->widget());
    if (button == nullptr) continue;
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setMinimumWidth(2 * button->iconSize().width());  // icons come later
  }
}

void setNumber(QTreeWidgetItem& row, int column, const QString& text) {
  row.setText(column, text);
  row.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
}

QString largestAllowanceText(const AssemblyStep& step) {
  double largest = 0.0;
  for (const StepAllowance& allowance : step.allowances) largest = std::max(largest, allowance.allowance);
  return largest > 0.0 ? lengthText(largest) : QStringLiteral("–");
}

QString checkText(StepCheck check) {
  switch (check) {
    case StepCheck::NotAsked: return SequencePanel::tr("certified");
    case StepCheck::Agrees: return SequencePanel::tr("✓ proved again");
    case StepCheck::Disagrees: break;
  }
  return SequencePanel::tr("✗ does not hold here");
}

}  // namespace

Language windowLanguage() { return QLocale().language() == QLocale::French ? Language::French : Language::English; }

SequencePanel::SequencePanel(const ActionCatalogue& actions, QWidget* parent)
    : QWidget(parent),
      summary_(new QLabel(this)),
      table_(new QTreeWidget(this)),
      play_(new PlaySlider(kPlayPlaces, kLongestPlay, this)),
      explode_(new PlaySlider(kExplodePlaces, kExplodeSeconds, this)),
      place_(new QLabel(this)) {
  summary_->setWordWrap(true);
  summary_->setTextFormat(Qt::PlainText);
  summary_->setObjectName(QStringLiteral("sequence-summary"));
  table_->setObjectName(QStringLiteral("sequence"));
  table_->setColumnCount(SequenceColumns);
  table_->setHeaderLabels({tr("No."), tr("Part"), tr("Motion"), tr("Clearance"), tr("Allowance"), tr("Tool"),
                           tr("Standing"), tr("Found after"), tr("State")});
  table_->headerItem()->setToolTip(Tool, tr("The tool that turns the fastener, and what it cannot be brought past"));
  table_->headerItem()->setToolTip(Standing, tr("Parts that would tip or fall"));
  table_->headerItem()->setToolTip(Seconds, tr("Seconds after planning began"));
  table_->headerItem()->setToolTip(LargestAllowance, tr("The largest of the step; its tool tip lists all"));
  table_->setRootIsDecorated(false);
  table_->setUniformRowHeights(true);
  table_->setAlternatingRowColors(true);
  table_->setTextElideMode(Qt::ElideMiddle);
  table_->setAccessibleName(tr("Steps of the sequence"));
  table_->setMinimumHeight(2 * fontMetrics().height());
  table_->header()->setSectionResizeMode(QHeaderView::Interactive);
  play_->setAccessibleName(tr("Place in the sequence"));
  play_->setToolTip(tr("Place in the sequence"));
  explode_->setAccessibleName(tr("Exploded view"));
  explode_->setToolTip(tr("Moves the parts apart along the directions in which they leave"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(4);
  auto* planning = makeActionRow(
      actions, {"sequence.plan", "sequence.resume", "sequence.graph", "sequence.open", "sequence.export"}, this);
  onlyIcons(*planning);
  qobject_cast<QToolButton*>(planning->itemAt(0)->widget())->setToolButtonStyle(Qt::ToolButtonTextOnly);
  layout->addLayout(planning);
  layout->addWidget(summary_);
  layout->addWidget(table_, 1);
  auto* playing = makeActionRow(actions, {"sequence.play", "sequence.assembly-order", "sequence.aside"}, this);
  onlyIcons(*playing);
  playing->insertWidget(1, play_, 1);
  playing->insertWidget(2, place_);
  layout->addLayout(playing);
  auto* exploding = new QHBoxLayout;
  auto* title = new QLabel(tr("E&xplode"), this);
  title->setBuddy(explode_);
  exploding->addWidget(title);
  exploding->addWidget(explode_, 1);
  layout->addLayout(exploding);
  setFocusProxy(table_);
  connect(table_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* row) { showRow(row); });
  connect(table_, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* row) { showRow(row); });
  connect(play_, &PlaySlider::shareShown, this, [this] {
    markRow();
    emit sceneChanged();
  });
  connect(play_, &PlaySlider::playbackEnded, this, &SequencePanel::playbackEnded);
  connect(explode_, &PlaySlider::shareShown, this, &SequencePanel::sceneChanged);
  setPlan({});
}

PlanWords SequencePanel::planWords() const {
  return PlanWords(windowLanguage(), [](double metres) { return lengthText(metres).toStdString(); });
}

QString SequencePanel::nameOf(const std::string& id) const {
  const auto body = shown_.product->indexOf(id);
  return QString::fromStdString(body ? shown_.product->bodies[*body].name : id);
}

/// A line each.
QString SequencePanel::allNames(const std::vector<std::string>& ids) const {
  QStringList names;
  for (const std::string& id : ids) names << nameOf(id);
  return names.join(QLatin1Char('\n'));
}

QString SequencePanel::shortNames(const std::vector<std::string>& ids) const {
  QStringList names;
  for (const std::string& id : ids) names << QString::fromStdString(shortName(nameOf(id).toStdString()));
  return names.join(QStringLiteral(", "));
}

void SequencePanel::setPlan(const ShownPlan& shown) {
  const double before = time();
  const bool samePlan = shown_.plan && shown.plan && shown_.product == shown.product;
  shown_ = shown;
  const std::size_t steps = shown.plan ? shown.plan->steps.size() : 0;
  {
    const QSignalBlocker block(table_);
    const int scrolled = table_->verticalScrollBar()->value();
    table_->clear();
    if (shown.plan) addSteps();
    if (shown.plan && !shown.growing) addStuck();
    for (const int column : {Number, LeastClearance, LargestAllowance, Tool, Standing, Seconds, State}) {
      table_->resizeColumnToContents(column);
    }
    table_->setColumnWidth(PartName, kPartWidth);
    table_->setColumnWidth(Motion, kMotionWidth);
    table_->verticalScrollBar()->setValue(shown.growing ? table_->verticalScrollBar()->maximum() : scrolled);
  }
  summary_->setText(summary());
  play_->setEnabled(steps > 0);
  explode_->setEnabled(steps > 0);
  play_->setSeconds(std::min(kLongestPlay, kSecondsPerStep * static_cast<double>(std::max<std::size_t>(4, steps))));
  if (!samePlan || steps == 0) {
    const QSignalBlocker block(explode_);
    explode_->setValue(0);
  }
  showTime(samePlan ? std::min(before, static_cast<double>(steps)) : 0.0);
}

void SequencePanel::addSteps() {
  const PlanWords words = planWords();
  const auto& steps = shown_.plan->steps;
  for (std::size_t place = 0; place < steps.size(); ++place) {
    const std::size_t i = order_ == PlanOrder::Assembly ? steps.size() - 1 - place : place;
    const AssemblyStep& step = steps[i];
    auto* row = new QTreeWidgetItem(table_);
    row->setData(Number, kStepRole, static_cast<qulonglong>(i));
    setNumber(*row, Number, QString::number(place + 1));
    row->setText(PartName, QString::fromStdString(nameOfStep(step, *shown_.product)));
    row->setToolTip(PartName, allNames(step.bodies()));
    row->setText(Motion, QString::fromStdString(words.motion(step, order_)));
    row->setToolTip(Motion, row->text(Motion));
    const bool isNear = !step.proof.nearest.empty();
    setNumber(*row, LeastClearance, isNear ? lengthText(step.proof.minClearance) : QStringLiteral("–"));
    if (isNear) {
      row->setToolTip(LeastClearance, tr("proved %1; smallest %2 to %3")
                                          .arg(lengthText(step.proof.provedClearance),
                                               lengthText(step.proof.minClearance), nameOf(step.proof.nearest)));
    }
    setNumber(*row, LargestAllowance, largestAllowanceText(step));
    QStringList allowances;
    for (const std::string& text : words.allowances(step, *shown_.product)) allowances << QString::fromStdString(text);
    row->setToolTip(LargestAllowance, allowances.join(QLatin1Char('\n')));
    row->setText(Tool, QString::fromStdString(words.tool(step, *shown_.product)));
    row->setToolTip(Tool, allNames(step.tool.blockedBy));
    row->setText(Standing, QString::fromStdString(words.standing(step, *shown_.product)));
    row->setToolTip(Standing, allNames(step.falling));
    const auto after = i < shown_.foundAfter.size() ? shown_.foundAfter[i] : std::nullopt;
    setNumber(*row, Seconds, after ? QLocale().toString(*after, 'f', 1) + QStringLiteral(" s") : QStringLiteral("–"));
    row->setText(State, checkText(i < shown_.checks.size() ? shown_.checks[i] : StepCheck::NotAsked));
    row->setToolTip(State, tr("found by %1").arg(QString::fromStdString(step.method)));
  }
}

void SequencePanel::addStuck() {
  QFont bold = table_->font();
  bold.setBold(true);
  for (const StuckBody& stuck : shown_.plan->stuck) {
    auto* row = new QTreeWidgetItem(table_);
    const QString name = nameOf(stuck.body);
    row->setData(Number, kStuckRole, QString::fromStdString(stuck.body));
    setNumber(*row, Number, QStringLiteral("–"));
    row->setText(PartName, QString::fromStdString(shortName(name.toStdString())));
    row->setToolTip(PartName, name);
    row->setText(
        Motion, stuck.blockedBy.empty() ? tr("no motion found") : tr("blocked by %1").arg(shortNames(stuck.blockedBy)));
    QStringList names;
    for (const std::string& other : stuck.blockedBy) names << nameOf(other);
    if (!stuck.reason.empty()) names << QString::fromStdString(stuck.reason);
    row->setToolTip(Motion, names.join(QLatin1Char('\n')));
    row->setText(State, tr("stuck"));
    row->setFont(State, bold);
  }
}

QString SequencePanel::summary() const {
  if (!shown_.product) return tr("No product is open.");
  if (!shown_.plan) return tr("Not planned yet.");
  const AssemblyPlan& plan = *shown_.plan;
  QString text = tr("%1 of %2 parts leave, every motion certified.").arg(plan.removed()).arg(plan.parts());
  const QString base = shortNames(plan.staying);
  if (!base.isEmpty()) text += QLatin1Char(' ') + tr("%1 stays.").arg(base);
  if (shown_.growing) return text + QLatin1Char(' ') + tr("Planning…");
  switch (plan.end) {
    case PlanEnd::Complete: break;
    case PlanEnd::Stuck: text += QLatin1Char(' ') + tr("%1 stuck.").arg(plan.parts() - plan.removed()); break;
    case PlanEnd::TimeLimit:
    case PlanEnd::Interrupted: text += QLatin1Char(' ') + tr("Stopped before the end."); break;
  }
  const auto refuted = std::count(shown_.checks.begin(), shown_.checks.end(), StepCheck::Disagrees);
  if (refuted > 0) text += QLatin1Char(' ') + tr("%1 steps do not hold here.").arg(refuted);
  return text;
}

void SequencePanel::setOrder(PlanOrder order) {
  if (order == order_) return;
  const double shown = time();
  order_ = order;
  setPlan(shown_);
  showTime(shown);
}

double SequencePanel::time() const {
  const double steps = shown_.plan ? static_cast<double>(shown_.plan->steps.size()) : 0.0;
  return steps * (order_ == PlanOrder::Assembly ? 1.0 - play_->share() : play_->share());
}

void SequencePanel::showTime(double time) {
  const double steps = shown_.plan ? static_cast<double>(shown_.plan->steps.size()) : 0.0;
  const double share = steps > 0.0 ? time / steps : 0.0;
  play_->showAt(order_ == PlanOrder::Assembly ? 1.0 - share : share);
}

/// Where the slider is: "3 / 17".
void SequencePanel::markRow() {
  const std::size_t steps = shown_.plan ? shown_.plan->steps.size() : 0;
  const double done = order_ == PlanOrder::Assembly ? static_cast<double>(steps) - time() : time();
  place_->setText(QStringLiteral("%1 / %2").arg(static_cast<int>(std::ceil(done - 1e-3))).arg(steps));
  const auto current = static_cast<int>(std::ceil(done - 1e-3)) - 1;
  const QSignalBlocker block(table_);
  if (current >= 0 && current < table_->topLevelItemCount() && done > 0.0) {
    table_->setCurrentItem(table_->topLevelItem(current));
  }
}

void SequencePanel::showRow(QTreeWidgetItem* row) {
  if (row == nullptr) return;
  if (const auto step = chosenStep()) {
    showTime(static_cast<double>(*step) + kOnTheWay);
  } else {
    emit stuckChosen(QString::fromStdString(chosenStuck()));
  }
}

std::optional<std::size_t> SequencePanel::chosenStep() const {
  const QTreeWidgetItem* row = table_->currentItem();
  if (row == nullptr || !row->data(Number, kStepRole).isValid()) return std::nullopt;
  return static_cast<std::size_t>(row->data(Number, kStepRole).toULongLong());
}

std::string SequencePanel::chosenStuck() const {
  const QTreeWidgetItem* row = table_->currentItem();
  return row == nullptr ? std::string() : row->data(Number, kStuckRole).toString().toStdString();
}

bool SequencePanel::chooseStep(std::size_t step) {
  for (int i = 0; i < table_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* row = table_->topLevelItem(i);
    if (!row->data(Number, kStepRole).isValid() || row->data(Number, kStepRole).toULongLong() != step) continue;
    const QSignalBlocker block(table_);
    table_->setCurrentItem(row);
    showRow(row);
    return true;
  }
  return false;
}

void SequencePanel::setPlaying(bool playing) { play_->setPlaying(playing); }

}  // namespace glissade
