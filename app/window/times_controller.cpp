#include "app/window/times_controller.h"

#include <utility>

#include "widgets/studies/plan_graph_view.h"
#include "widgets/studies/times_view.h"

namespace glissade {

TimesController::TimesController(const Workbench& bench, const SequenceController& sequence)
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
  addCommands();
}

void TimesController::enableAction() {
  const ShownPlan& shown = sequence_.shown();
  bench_.enable("sequence.times", shown.plan && !shown.plan->steps.empty());
}

void TimesController::show() {
  if (view_ == nullptr) {
    view_ = new TimesView(&bench_.window);
    connect(view_, &TimesView::stationsChanged, this, &TimesController::update);
  }
  view_->show();
  view_->raise();
  update();
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
  const auto work = [this, plan, product, stations](const WorkWatch&) -> BackgroundTask::Delivery {
    const auto timing = planTiming(*plan, *product, WorkTimes(), stations);
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

void TimesController::addCommands() {
  bench_.scripts.add("times", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    show();
    view_->setStations(QString::fromStdString(words[0]).toInt());
    return Done{};
  });
  bench_.scripts.add("expect-times", 2, [this](const ScriptCommands::Words& words) -> Outcome {
    if (words[0] != "stations") return wrongCommand("'" + words[0] + "' is no number of the times", "Say stations.");
    const std::string number = std::to_string(view_ == nullptr ? 0 : view_->shownBars());
    if (number == words[1]) return Done{};
    return unmetExpectation("there are bars of " + number + " stations, not " + words[1]);
  });
}

}  // namespace glissade
