#include "app/window/times_controller.h"

#include <utility>

#include "app/window/times_script.h"
#include "engine/scenario/work_times_json.h"
#include "widgets/studies/plan_graph_view.h"
#include "widgets/studies/times_view.h"

namespace glissade {

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
      task_, [] { return tr("Dividing the work"); }, [this] { task_.cancel(); });
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
  connect(&editor, &WorkTimesEditor::undoAsked, &undo, &QUndoStack::undo);
  connect(&editor, &WorkTimesEditor::redoAsked, &undo, &QUndoStack::redo);
  connect(&editor, &WorkTimesEditor::openAsked, this, &TimesController::chooseFile);
  connect(&editor, &WorkTimesEditor::saveAsked, this, &TimesController::chooseTarget);
}

/// CBC does not stop early: what is asked while it works waits for its end.
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
        bench_.messages.showError(tr("The work cannot be divided"), timing.error());
      }
    };
  };
  task_.start("dividing the work", work, bench_.work.isAtOnce());
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
  bench_.messages.showStatus(tr("The table of times was saved as %1").arg(file));
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
