#include "widgets/sequence/step_table.h"

#include <QAction>
#include <QDropEvent>
#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLocale>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QStyle>
#include <QStyledItemDelegate>

#include <algorithm>
#include <climits>

#include "engine/documents/instruction/instruction_words.h"
#include "engine/documents/plan_tasks.h"
#include "engine/sequence/demand_edits.h"
#include "engine/sequence/plan_bodies.h"
#include "widgets/controls/body_id_text.h"
#include "widgets/controls/cell_delegates.h"
#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/length_text.h"
#include "widgets/controls/quiet_focus.h"
#include "widgets/sequence/access_texts.h"

namespace glissade {
namespace {

enum StepColumn { StepNumber, StepPart, StepGaps, StepTools, StepState, StepColumns };

constexpr int kStepRole = Qt::UserRole;         // index in the plan
constexpr int kStuckRole = Qt::UserRole + 1;    // id of a stuck part
constexpr int kPictureRole = Qt::UserRole + 2;  // id of the body in the picture
constexpr int kWholeRole = Qt::UserRole + 3;    // text that is shown with more lines where it is wrapped
constexpr int kMostLines = 3;                   // lines of which a wrapped line consists at most
constexpr int kPartColumn = 184;
constexpr int kLeastPartColumn = 120;
constexpr int kLeastToolColumn = 48;
constexpr int kPictureSize = 32;
constexpr int kWrappedMargin = 16;  ///< about the text beside a picture, and between both

/// Sets a text that is wrapped where its column is narrow.
void setWrapped(QTreeWidgetItem& row, int column, const QString& text) {
  row.setText(column, text);
  row.setData(column, kWholeRole, text);
}

QString wholeText(const QTreeWidgetItem& row, int column) {
  const QVariant whole = row.data(column, kWholeRole);
  return whole.isValid() ? whole.toString() : row.text(column);
}

QString twoLines(const QString& upper, const QString& lower) { return upper + QLatin1Char('\n') + lower; }

/// The text as a sentence: "No motion was found." for "no motion was found".
QString sentence(const QString& text) {
  return text.left(1).toUpper() + text.mid(1) + (text.endsWith(QLatin1Char('.')) ? QString() : QStringLiteral("."));
}

QString joinedTexts(const std::vector<std::string>& texts, const QString& separator) {
  QStringList list;
  for (const std::string& text : texts) list << QString::fromStdString(text);
  return list.join(separator);
}

QString largestAllowanceText(const std::vector<Allowance>& allowances) {
  double largest = 0.0;
  for (const auto& allowance : allowances) largest = std::max(largest, allowance.allowance);
  return largest > 0.0 ? columnLengthText(largest) : QStringLiteral("–");
}

QString checkText(StepCheck check) {
  switch (check) {
    case StepCheck::NotAsked: return StepTable::tr("certified");
    case StepCheck::Agrees: return StepTable::tr("✓ certified");
    case StepCheck::Disagrees: break;
  }
  return StepTable::tr("✗ not valid");
}

QString checkTip(StepCheck check) {
  switch (check) {
    case StepCheck::NotAsked: return StepTable::tr("certified when it was found");
    case StepCheck::Agrees: return StepTable::tr("certified again by the independent check");
    case StepCheck::Disagrees: break;
  }
  return StepTable::tr("not valid in this arrangement");
}

/// Shows rows of stuck parts, whose texts have as many lines as they need.
class WrappedDelegate final : public QStyledItemDelegate {
 public:
  explicit WrappedDelegate(QTreeView* table) : QStyledItemDelegate(table), table_(table) {}

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QSize size = QStyledItemDelegate::sizeHint(option, index);
    if (!index.data(kStuckRole).isValid()) return size;
    const int width = table_->viewport()->width() - table_->iconSize().width() - kWrappedMargin;
    const QRect box = table_->fontMetrics().boundingRect(QRect(0, 0, std::max(1, width), INT_MAX / 2), Qt::TextWordWrap,
                                                         index.data().toString());
    return {size.width(), std::max(size.height(), box.height() + kWrappedMargin / 2)};
  }

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    if (index.data(kStuckRole).isValid()) option->features |= QStyleOptionViewItem::WrapText;
  }

 private:
  QTreeView* table_;
};

/// A person's changes of the step: "locked", "by hand".
QString markOf(const StepDemands& demands, const AssemblyStep& step) {
  QStringList marks;
  const bool isByHand = std::any_of(step.motions.begin(), step.motions.end(),
                                    [](const StepMotion& motion) { return motion.method == kByHand; });
  if (isByHand) marks << StepTable::tr("by hand");
  if (demands.isLocked()) {
    marks << StepTable::tr("locked");
  } else if (demands.place != nullptr) {
    marks << StepTable::tr("placed");
  }
  return marks.join(QStringLiteral(", "));
}

bool isIsolated(const AssemblyStep& step, const AssemblyPlan& plan) {
  const BodyId& body = step.motions.front().body;
  return std::find(plan.isolated.begin(), plan.isolated.end(), body) != plan.isolated.end();
}

QString methodsOf(const AssemblyStep& step) {
  QStringList methods;
  for (const StepMotion& motion : step.motions) methods << engineText(methodInWords(motion.method));
  methods.removeDuplicates();
  return methods.join(QStringLiteral(", "));
}

}  // namespace

PlanWords windowPlanWords() {
  const MessageStyle style = windowStyle();
  return {style.language, style.length};
}

StepTable::StepTable(IconOf iconOf, QWidget* parent) : QTreeWidget(parent), iconOf_(std::move(iconOf)) {
  setObjectName(QStringLiteral("sequence"));
  keepUnchosen(*this);
  setColumnCount(StepColumns);
  setHeaderLabels({tr("No."), twoLines(tr("Part"), tr("Motion")), twoLines(tr("Clearance"), tr("Allowance")),
                   twoLines(tr("Tool"), tr("Support")), tr("State")});
  headerItem()->setToolTip(StepGaps,
                           tr("Above: smallest distance to other parts on the motion. Below: how much thinner "
                              "the part counts where the file lets parts touch or overlap, such as a fit"));
  headerItem()->setToolTip(
      StepTools, tr("Above: the tool that turns the fastener, and what blocks it. Below: parts that need support "
                    "because they would tip or fall, or the constraints that a forced step violates"));
  headerItem()->setToolTip(StepState, tr("Above: whether the motion is certified. Below: edits of the step"));
  setRootIsDecorated(false);
  setAlternatingRowColors(true);
  setIconSize({kPictureSize, kPictureSize});
  setTextElideMode(Qt::ElideMiddle);
  setItemDelegateForColumn(StepNumber, new WrappedDelegate(this));
  setItemDelegateForColumn(StepPart, new NameDelegate(StepPart, this));
  for (const int column : {StepGaps, StepTools, StepState}) {
    setItemDelegateForColumn(column, new WholeWordsDelegate(this));
  }
  setAccessibleName(tr("Steps of the sequence"));
  header()->setSectionResizeMode(QHeaderView::Interactive);
  header()->setMinimumSectionSize(20);
  connect(header(), &QHeaderView::sectionResized, this, [this](int column) {
    if (column != StepPart && column != StepTools) return;
    wrapTexts();
    scheduleDelayedItemsLayout();
  });
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setDragDropMode(QAbstractItemView::InternalMove);
  setDropIndicatorShown(true);
}

QString StepTable::nameOf(const BodyId& id) const { return QString::fromStdString(shownNameOf(id, *shown_.product)); }

/// The names of the bodies, one on each line.
QString StepTable::allNames(const std::vector<BodyId>& ids) const {
  QStringList names;
  for (const BodyId& id : ids) names << nameOf(id);
  return names.join(QLatin1Char('\n'));
}

QString StepTable::shortNames(const std::vector<BodyId>& ids) const {
  QStringList names;
  for (const BodyId& id : ids) names << nameOf(id);
  return names.join(QStringLiteral(", "));
}

void StepTable::show(const ShownPlan& shown, PlanOrder order) {
  const QSignalBlocker block(this);
  const int scrolled = verticalScrollBar()->value();
  shown_ = shown;
  order_ = order;
  clear();
  const std::size_t steps = shown.plan ? shown.plan->steps.size() : 0;
  for (std::size_t place = 0; place < steps; ++place) addStep(place);
  const std::size_t before = shown.growing && shown.before ? shown.before->steps.size() : 0;
  for (std::size_t i = steps; i < before; ++i) addEarlier(order == PlanOrder::Assembly ? before - 1 - i + steps : i);
  if (shown.plan && !shown.growing) {
    for (const StuckBody& stuck : shown.plan->stuck) addStuck(stuck);
  }
  fitColumns();
  verticalScrollBar()->setValue(shown.growing ? verticalScrollBar()->maximum() : scrolled);
  setDragEnabled(!shown.growing);
}

/// Makes the state visible without scrolling; names of parts and tools are cut if there is little room.
void StepTable::fitColumns() {
  const QSignalBlocker block(this);
  for (int i = 0; i < topLevelItemCount(); ++i) {
    for (const int column : {StepPart, StepTools})
      topLevelItem(i)->setText(column, wholeText(*topLevelItem(i), column));
  }
  for (const int column : {StepNumber, StepGaps}) resizeColumnToContents(column);
  // The last column takes the remaining width, which says nothing about its contents.
  const int state = std::max(sizeHintForColumn(StepState), header()->sectionSizeHint(StepState));
  const int used = columnWidth(StepNumber) + columnWidth(StepGaps) + state;
  const int inside = width() - 2 * frameWidth() - style()->pixelMetric(QStyle::PM_ScrollBarExtent);
  const int left = inside - used;
  const int tools = std::max(sizeHintForColumn(StepTools), header()->sectionSizeHint(StepTools));
  const int wanted = std::clamp(sizeHintForColumn(StepPart), kLeastPartColumn, kPartColumn);
  const int most = std::max(wanted, left - tools);  // what the tools leave free
  const int part = std::clamp(left - columnWidth(StepGaps), kLeastPartColumn, most);
  setColumnWidth(StepPart, part);
  setColumnWidth(StepTools, std::max(kLeastToolColumn, left - part));
  setColumnWidth(StepState, state);
  wrapTexts();
}

/// Wraps motions, tools and support in their columns. Names are told apart in one line (NameDelegate).
void StepTable::wrapTexts() {
  const QSignalBlocker block(this);
  const int margins = 2 * (style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 1);
  for (int i = 0; i < topLevelItemCount(); ++i) {
    QTreeWidgetItem& row = *topLevelItem(i);
    for (const int column : {StepPart, StepTools}) {
      if (!row.data(column, kWholeRole).isValid()) continue;
      const int picture = row.icon(column).isNull() ? 0 : kPictureSize + margins;
      const QStringList lines = wholeText(row, column).split(QLatin1Char('\n'));
      QStringList wrapped;
      for (int line = 0; line < lines.size(); ++line) {
        const bool isName = column == StepPart && line == 0;
        wrapped << (isName ? QStringList(lines[line])
                           : wrappedLines(lines[line], fontMetrics(), columnWidth(column) - picture - margins,
                                          kMostLines));
      }
      row.setText(column, wrapped.join(QLatin1Char('\n')));
    }
  }
}

void StepTable::setIcon(QTreeWidgetItem& row, const BodyId& bodyId) {
  row.setData(StepNumber, kPictureRole, toQString(bodyId));
  const auto body = shown_.product->find(bodyId);
  const int column = row.isFirstColumnSpanned() ? StepNumber : StepPart;
  if (body) row.setIcon(column, iconOf_(shown_.product->bodies[*body]));
}

void StepTable::takeIcons() {
  for (int i = 0; i < topLevelItemCount(); ++i) {
    QTreeWidgetItem* row = topLevelItem(i);
    setIcon(*row, toBodyId(row->data(StepNumber, kPictureRole).toString()));
  }
}

void StepTable::addStep(std::size_t place) {
  const PlanWords words = windowPlanWords();
  const auto& steps = shown_.plan->steps;
  const std::size_t i = order_ == PlanOrder::Assembly ? steps.size() - 1 - place : place;
  const AssemblyStep& step = steps[i];
  auto* row = new QTreeWidgetItem(this);
  row->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled);
  row->setData(StepNumber, kStepRole, static_cast<qulonglong>(i));
  // The number in the order of assembly is not known while the plan grows.
  if (!shown_.growing) {
    row->setText(StepNumber, QString::fromStdString(stepNumber(steps.size() - 1 - i)));
  }
  row->setTextAlignment(StepNumber, Qt::AlignRight | Qt::AlignVCenter);
  setIcon(*row, motionsOf(step, PlanOrder::Assembly).front()->body);
  const QString motion = QString::fromStdString(words.motion(step, order_));
  const QString work = QString::fromStdString(words.work(step, *shown_.product, order_));
  const QString turn = turnBefore(place);
  setWrapped(*row, StepPart,
             twoLines(QString::fromStdString(nameOfStep(step, *shown_.product)),
                      turn.isEmpty() ? work : twoLines(turn, work)));
  QStringList told{allNames(step.bodies()), turn, work, motion};
  told.removeAll(QString());
  told.removeDuplicates();
  row->setToolTip(StepPart, told.join(QLatin1Char('\n')));
  showGaps(*row, i);
  showSupport(*row, step);
  const auto& checks = shown_.check.steps;
  const StepCheck check = i < checks.size() ? checks[i] : StepCheck::NotAsked;
  const MotionAccess* access = shown_.access ? &shown_.access->steps[i] : nullptr;
  const QStringList inside = access != nullptr ? unreachedInside(i) : QStringList();
  QStringList marks{access != nullptr ? accessMark(*access) : QString(),
                    inside.isEmpty() ? QString() : tr("%n inside not reached", "", inside.size()),
                    isIsolated(step, *shown_.plan) ? tr("touches nothing") : QString(),
                    markOf(demandsOn(step.bodies(), shown_.plan->demands), step)};
  marks.removeAll(QString());
  row->setText(StepState, twoLines(checkText(check), marks.join(QStringLiteral(", "))));
  QStringList tips{checkTip(check), tr("found by %1").arg(methodsOf(step))};
  if (isIsolated(step, *shown_.plan)) tips << tr("The part touches nothing: it may lie beside the product.");
  if (access != nullptr) tips << accessText(*access, shown_.product->bodies) << inside;
  const double after = foundAfter(step);
  if (after > 0.0) tips << tr("found after %1 s of computing").arg(QLocale().toString(after, 'f', 1));
  row->setToolTip(StepState, tips.join(QLatin1Char('\n')));
}

/// How the product is turned before the step of this row; empty: it lies as before.
QString StepTable::turnBefore(std::size_t place) const {
  if (shown_.views.empty()) return {};
  const auto viewAt = [this](std::size_t row) {
    return shown_.views[order_ == PlanOrder::Assembly ? shown_.views.size() - 1 - row : row];
  };
  const Viewpoint before = place == 0 ? Viewpoint() : viewAt(place - 1);
  return QString::fromStdString(turnSentence(before, viewAt(place), windowPlanWords().words()));
}

/// Shows the tool of the step, and the parts that need support or the rules that it violates.
void StepTable::showSupport(QTreeWidgetItem& row, const AssemblyStep& step) const {
  const PlanWords words = windowPlanWords();
  const StepMotion& opening = step.opening();
  const QString tool = QString::fromStdString(words.tool(opening, *shown_.product));
  const QString violated = joinedTexts(words.violations(step, *shown_.product), QStringLiteral("; "));
  const QString forced = violated.isEmpty() ? QString() : tr("forced: %1").arg(violated);
  const QString standing = QString::fromStdString(words.standing(step, *shown_.product));
  setWrapped(row, StepTools, twoLines(tool, forced.isEmpty() ? standing : forced));
  if (!forced.isEmpty()) row.setForeground(StepTools, palette().brush(QPalette::BrightText));
  QStringList tips{tool, allNames(opening.tool.blockedBy), forced,
                   QString::fromStdString(words.support(step, *shown_.product, order_))};
  tips.removeAll(QString());
  row.setToolTip(StepTools, tips.join(QLatin1Char('\n')));
}

/// Shows the smallest clearance and the largest allowance of the step's motions.
void StepTable::showGaps(QTreeWidgetItem& row, std::size_t step) const {
  std::vector<Allowance> allowances;
  const StepProof* least = nullptr;
  QStringList tips;
  for (const StepMotion* motion : motionsOf(shown_.plan->steps[step], order_)) {
    const std::vector<Allowance> own = allowancesInOrder(shown_.plan->steps, step, *motion);
    allowances.insert(allowances.end(), own.begin(), own.end());
    const StepProof& proof = motion->proof;
    if (proof.nearest.empty()) continue;
    tips << tr("Clearance: the smallest distance on the whole motion is %1, to %2; at least %3 is certified. It is "
               "certified because it is not below the required clearance.")
                .arg(lengthText(proof.minClearance), nameOf(proof.nearest), lengthText(proof.provedClearance));
    if (least == nullptr || proof.minClearance < least->minClearance) least = &proof;
  }
  row.setText(StepGaps, twoLines(least != nullptr ? columnLengthText(least->minClearance) : QStringLiteral("–"),
                                 largestAllowanceText(allowances)));
  row.setTextAlignment(StepGaps, Qt::AlignRight | Qt::AlignVCenter);
  const QString allowed = joinedTexts(windowPlanWords().allowances(allowances, *shown_.product), QStringLiteral("\n"));
  if (!allowed.isEmpty()) {
    tips
        << tr("Allowance: the file lets these parts touch or overlap, so that the moving part counts as thinner by "
              "this "
              "length against them. An allowance above the clearance is usual for a fit; the clearance is what is left "
              "beside it.")
        << allowed;
  }
  row.setToolTip(StepGaps, tips.join(QLatin1Char('\n')));
}

/// Seconds of computing until all motions of the step were found; 0: they were not found here.
double StepTable::foundAfter(const AssemblyStep& step) const {
  double after = 0.0;
  for (const StepMotion& motion : step.motions) {
    const auto found = shown_.foundAfter.find(motion.body);
    if (found != shown_.foundAfter.end()) after = std::max(after, found->second);
  }
  return after;
}

/// A line for each step inside the groups of a step that the hand does not reach, or that cannot be seen.
QStringList StepTable::unreachedInside(std::size_t step) const {
  QStringList texts;
  const auto& lines = shown_.plan->lines;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].step == step + 1) addUnreached(lines[i], shown_.access->lines[i], texts);
  }
  return texts;
}

void StepTable::addUnreached(const SubassemblyLine& line, const LineAccess& access, QStringList& texts) const {
  for (std::size_t i = 0; i < access.steps.size(); ++i) {
    if (access.steps[i].isReachedAndSeen()) continue;
    texts << tr("%1, in its group: %2")
                 .arg(QString::fromStdString(nameOfStep(line.steps[i], *shown_.product)),
                      accessText(access.steps[i], shown_.product->bodies));
  }
  for (std::size_t i = 0; i < access.lines.size(); ++i) addUnreached(line.lines[i], access.lines[i], texts);
}

/// Adds a grey row with a step of the earlier plan, which the new plan has not reached.
void StepTable::addEarlier(std::size_t step) {
  const AssemblyStep& old = shown_.before->steps[step];
  auto* row = new QTreeWidgetItem(this);
  row->setFlags(Qt::NoItemFlags);
  const QString work = QString::fromStdString(windowPlanWords().work(old, *shown_.product, order_));
  row->setText(StepPart, twoLines(QString::fromStdString(nameOfStep(old, *shown_.product)), work));
  row->setText(StepState, tr("earlier plan"));
}

/// Adds a row with the full reason and the next action, over all columns.
void StepTable::addStuck(const StuckBody& stuck) {
  auto* row = new QTreeWidgetItem(this);
  row->setFirstColumnSpanned(true);
  row->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  row->setData(StepNumber, kStuckRole, toQString(stuck.body));
  setIcon(*row, stuck.body);
  const bool isEnded = shown_.plan->end == PlanEnd::Stuck;
  QStringList sentences{(isEnded ? tr("%1 is stuck.") : tr("%1 was not removed.")).arg(shortNames({stuck.body}))};
  if (!stuck.blockedBy.empty()) sentences << tr("Blocked by %1.").arg(shortNames(stuck.blockedBy));
  if (!stuck.reason.empty()) sentences << sentence(engineText(stuck.reason));
  sentences << (isEnded ? tr("Next: decide about its fits and joints (Contacts), move it by hand (menu of the row), or "
                             "see the precedence graph.")
                        : tr("Next: resume planning."));
  row->setText(StepNumber, sentences.join(QLatin1Char(' ')));
  row->setToolTip(StepNumber, twoLines(nameOf(stuck.body), allNames(stuck.blockedBy)).trimmed());
}

void StepTable::resizeEvent(QResizeEvent* event) {
  QTreeWidget::resizeEvent(event);
  fitColumns();
  scheduleDelayedItemsLayout();  // wraps the texts of stuck parts
}

std::optional<std::size_t> StepTable::stepOf(const QTreeWidgetItem* row) {
  if (row == nullptr || !row->data(StepNumber, kStepRole).isValid()) return std::nullopt;
  return static_cast<std::size_t>(row->data(StepNumber, kStepRole).toULongLong());
}

BodyId StepTable::stuckOf(const QTreeWidgetItem* row) {
  return row == nullptr ? BodyId() : toBodyId(row->data(StepNumber, kStuckRole).toString());
}

QTreeWidgetItem* StepTable::rowOf(std::size_t step) const {
  for (int i = 0; i < topLevelItemCount(); ++i) {
    if (stepOf(topLevelItem(i)) == step) return topLevelItem(i);
  }
  return nullptr;
}

QString StepTable::textOf(std::size_t step) const {
  const QTreeWidgetItem* row = rowOf(step);
  QStringList texts;
  for (int column = 0; row != nullptr && column < StepColumns; ++column) texts << wholeText(*row, column);
  return texts.join(QLatin1Char('\n'));
}

std::vector<std::size_t> StepTable::selectedSteps() const {
  std::vector<std::size_t> steps;
  for (const QTreeWidgetItem* row : selectedItems()) {
    if (const auto step = stepOf(row)) steps.push_back(*step);
  }
  std::sort(steps.begin(), steps.end());
  return steps;
}

/// Shows the plan again with new texts and colours.
void StepTable::changeEvent(QEvent* event) {
  QTreeWidget::changeEvent(event);
  const bool isRead = event->type() == QEvent::LocaleChange || event->type() == QEvent::PaletteChange;
  if (isRead && shown_.plan) show(ShownPlan(shown_), order_);
}

void StepTable::dropEvent(QDropEvent* event) {
  event->setDropAction(Qt::IgnoreAction);
  event->accept();
  dropAt(event->pos());
}

/// Keys of commands never move the selection. The table would receive them while a command is disabled, and from the
/// keypad, whose keys have a modifier that shortcuts do not match.
void StepTable::keyPressEvent(QKeyEvent* event) {
  const int modifiers = static_cast<int>(event->modifiers() & ~Qt::KeypadModifier);
  const QKeySequence keys(event->key() | modifiers);
  for (QAction* action : actions()) {
    if (modifiers == 0 || action->shortcut() != keys) continue;
    if (action->isEnabled()) action->trigger();  // trigger() does not ask for this
    return;
  }
  QTreeWidget::keyPressEvent(event);
}

void StepTable::dropAt(const QPoint& place) {
  const auto from = stepOf(currentItem());
  if (!from) return;
  QTreeWidgetItem* target = itemAt(place);
  const bool below = target != nullptr && place.y() > visualItemRect(target).center().y();
  const int row = target == nullptr ? topLevelItemCount() : indexOfTopLevelItem(target);
  const int own = indexOfTopLevelItem(currentItem());
  int to = row + (below ? 1 : 0);  // row before which it is inserted
  if (to > own) --to;
  const auto steps = static_cast<int>(shown_.plan->steps.size());
  const auto there = stepOf(topLevelItem(std::clamp(to, 0, steps - 1)));
  if (there && *there != *from) emit stepDragged(static_cast<int>(*from), static_cast<int>(*there));
}

}  // namespace glissade
