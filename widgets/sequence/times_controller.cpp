#include "widgets/sequence/times_controller.h"

#include <algorithm>
#include <utility>

#include "engine/base/number_text.h"
#include "engine/files/work_times_json.h"
#include "widgets/sequence/plan_graph_view.h"
#include "widgets/sequence/times_view.h"

namespace glissade {
namespace {

using Words = ScriptCommands::Words;

/// The index in workTimeRows(); nothing if no row has this id.
std::optional<std::size_t> rowOf(const std::string& id) {
  const auto& rows = workTimeRows();
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const WorkTimeRow& row) { return row.id == id; });
  if (found == rows.end()) return std::nullopt;
  return static_cast<std::size_t>(found - rows.begin());
}

Diagnostic unknownRow(const std::string& id) {
  return wrongCommand("'" + id + "' is no work time", "Take the names that 'times --write-table' writes.");
}

Outcome setTime(TimesView& view, const std::string& id, const std::string& text) {
  const auto row = rowOf(id);
  if (!row) return unknownRow(id);
  view.showTable();
  view.table().write(*row, QString::fromStdString(text));
  return Done{};
}

Outcome expectTime(const WorkTimes& times, const std::string& id, const std::string& expected) {
  const auto row = rowOf(id);
  if (!row) return unknownRow(id);
  const std::string value = toText(times.*workTimeRows()[*row].value);
  if (value == expected) return Done{};
  return unmetExpectation("'" + id + "' is " + value + ", not " + expected);
}

Outcome expectTimes(const TimesView& view, const std::string& what, const std::string& expected) {
  std::string found;
  if (what == "stations") {
    found = std::to_string(view.shownBars());
  } else if (what == "sum") {
    found = QString::number(view.shownSeconds(), 'f', 1).toStdString();
  } else {
    return wrongCommand("'" + what + "' is no number of the times", "Say stations or sum.");
  }
  if (found == expected) return Done{};
  return unmetExpectation("the times have " + what + " " + found + ", not " + expected);
}

/// Adds the script commands about the times of the assembly and their table.
void addTimesCommands(const Workbench& bench, TimesController& times) {
  bench.scripts.add("times", 1, [&times](const Words& words) -> Outcome {
    times.show();
    times.view().setStations(QString::fromStdString(words[0]).toInt());
    return Done{};
  });
  bench.scripts.add("expect-times", 2,
                    [&times](const Words& words) { return expectTimes(times.view(), words[0], words[1]); });
  bench.scripts.add("set-time", 2, [&times](const Words& words) { return setTime(times.view(), words[0], words[1]); });
  bench.scripts.add("expect-time", 2,
                    [&times](const Words& words) { return expectTime(times.table().times(), words[0], words[1]); });
  bench.scripts.add("open-times", 1, [&times](const Words& words) {
    return outcomeOf(times.openTable(QString::fromStdString(words[0])));
  });
  bench.scripts.add("save-times", 1, [&times](const Words& words) {
    return outcomeOf(times.saveTable(QString::fromStdString(words[0])));
  });
}

}  // namespace

TimesController::TimesController(const Workbench& bench, SequenceController& sequence)
    : QObject(&bench.window), bench_(bench), sequence_(sequence) {
  bench.onAction("sequence.times", this, [this] { show(); });
  connect(&sequence, &SequenceController::planShown, this, [this] {
    enableAction();
    update();
  });
  connect(&task_, &BackgroundTask::failed, &bench.work, &WorkController::reportFailure);
  connect(&task_, &BackgroundTask::ended, this, [this] {
    if (std::exchange(isOutdated_, false)) update();
  });
  bench.work.show(
      task_, [] { return tr("Balancing the line"); }, [this] { task_.cancel(); });
  enableAction();
  addTimesCommands(bench, *this);
}

void TimesController::enableAction() {
  const ShownPlan& shown = sequence_.shown();
  bench_.enable("sequence.times", shown.plan && !shown.plan->steps.empty());
}

void TimesController::show() {
  view().show();
  view().raise();
  update();
}

TimesView& TimesController::view() {
  if (view_ == nullptr) makeView();
  return *view_;
}

void TimesController::makeView() {
  view_ = new TimesView(&bench_.window);
  connect(view_, &TimesView::stationsChanged, this, &TimesController::update);
  WorkTimesEditor& editor = view_->table();
  QUndoStack& undo = table().undoStack();
  editor.setTimes(table().times());
  editor.setCanUndo(undo.canUndo());
  editor.setCanRedo(undo.canRedo());
  connect(&table(), &WorkTimesStore::changed, this, [this] {
    view_->table().setTimes(table().times());
    update();
  });
  connect(&undo, &QUndoStack::canUndoChanged, &editor, &WorkTimesEditor::setCanUndo);
  connect(&undo, &QUndoStack::canRedoChanged, &editor, &WorkTimesEditor::setCanRedo);
  connect(&editor, &WorkTimesEditor::edited, &table(), &WorkTimesStore::edit);
  connect(&editor, &WorkTimesEditor::undoRequested, &undo, &QUndoStack::undo);
  connect(&editor, &WorkTimesEditor::redoRequested, &undo, &QUndoStack::redo);
  connect(&editor, &WorkTimesEditor::openRequested, this, &TimesController::chooseFile);
  connect(&editor, &WorkTimesEditor::saveRequested, this, &TimesController::chooseTarget);
}

/// Computes the times. A running CBC cannot be stopped, so a later request waits for its end.
void TimesController::update() {
  if (view_ == nullptr || !view_->isVisible()) return;
  const ShownPlan& shown = sequence_.shown();
  if (!shown.plan || shown.plan->steps.empty()) {
    view_->setTiming(std::nullopt, graphColours(bench_.window.palette()));
  } else if (task_.isBusy()) {
    isOutdated_ = true;
  } else if (!shown.growing) {
    divide(shown.plan, shown.product);
  }
}

void TimesController::divide(const PlanPtr& plan, const ProductPtr& product) {
  const int count = view_->stations();
  const std::optional<std::size_t> stations = count > 1 ? std::optional(static_cast<std::size_t>(count)) : std::nullopt;
  const auto work = [this, plan, product, stations,
                     times = table().times()](const WorkWatch&) -> BackgroundTask::Delivery {
    const auto timing = planTiming(*plan, *product, times, stations);
    return [this, plan, timing] {
      if (sequence_.shown().plan != plan) return;
      if (timing) {
        view_->setTiming(*timing, graphColours(bench_.window.palette()));
      } else {
        bench_.messages.showError(tr("The line cannot be balanced"), timing.error());
      }
    };
  };
  task_.start(GLISSADE_TEXT("balancing the line"), work, bench_.work.isAtOnce());
}

std::optional<Diagnostic> TimesController::openTable(const QString& file) {
  const auto times = readWorkTimes(file.toStdString());
  if (!times) return times.error();
  table().edit(*times);
  bench_.messages.showStatus(tr("The table of times of %1 is used").arg(file));
  return std::nullopt;
}

std::optional<Diagnostic> TimesController::saveTable(const QString& file) {
  const Outcome saved = saveWorkTimes(table().times(), file.toStdString());
  if (!saved) return saved.error();
  bench_.messages.showSaved(tr("The table of times was saved as %1").arg(file), file);
  return std::nullopt;
}

void TimesController::chooseFile() {
  const QString file = bench_.dialogs.open(FilePurpose::Times, tr("Open a table of times"),
                                           tr("Tables of times (*.json);;All files (*)"), view_);
  if (file.isEmpty()) return;
  if (const auto why = openTable(file)) bench_.messages.showError(tr("The table of times cannot be opened"), *why);
}

void TimesController::chooseTarget() {
  const QString file = bench_.dialogs.save(FilePurpose::Times, tr("Save the table of times"),
                                           QStringLiteral("times.json"), tr("Tables of times (*.json)"), view_);
  if (file.isEmpty()) return;
  if (const auto why = saveTable(file)) bench_.messages.showError(tr("The table of times cannot be saved"), *why);
}

}  // namespace glissade
