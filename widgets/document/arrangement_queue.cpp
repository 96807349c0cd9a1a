#include "widgets/document/arrangement_queue.h"

#include <QScopedValueRollback>

#include <utility>

namespace glissade {

ArrangementQueue::ArrangementQueue(Basis basis, MakeLoad makeLoad, QObject* parent)
    : QObject(parent), basis_(std::move(basis)), makeLoad_(std::move(makeLoad)) {
  connect(&task_, &BackgroundTask::failed, this, [this](const Diagnostic& why) {
    refuse(why);
    beginNext();
  });
}

Outcome ArrangementQueue::add(Job job) {
  const bool waits = jobs_.size() > 1 && !job.mergeKey.isEmpty() && jobs_.back().mergeKey == job.mergeKey;
  if (waits) jobs_.pop_back();
  jobs_.push_back(std::move(job));
  if (jobs_.size() > 1) return Done{};
  const QScopedValueRollback<bool> adding(adding_, true);
  refusal_.reset();
  beginNext();
  return refusal_ ? Outcome(*std::exchange(refusal_, std::nullopt)) : Outcome(Done{});
}

void ArrangementQueue::cancel() {
  jobs_.clear();
  underWay_ = false;
  task_.cancel();
}

/// Begins the next job that has a scenario to load; jobs without one are done on the way.
void ArrangementQueue::beginNext() {
  while (!jobs_.empty()) {
    const Job& job = jobs_.front();
    basedOn_ = basis_();
    underWay_ = true;
    auto scenario = job.begin();
    if (jobs_.empty()) return;  // cancelled
    if (!scenario) {
      refuse(scenario.error());
      continue;
    }
    if (!*scenario) {
      underWay_ = false;
      jobs_.pop_front();
      continue;
    }
    const auto work = [this, load = makeLoad_(), asked = std::move(**scenario)](const WorkWatch& watch) {
      return [this, loaded = load(asked, watch.stop)] { take(loaded); };
    };
    task_.start(GLISSADE_TEXT("arranging the product"), work, atOnce_);
    return;
  }
}

void ArrangementQueue::take(const Result<ScenarioPtr>& loaded) {
  if (jobs_.empty()) return;
  if (!loaded) {
    refuse(loaded.error());
  } else if (basis_() == basedOn_) {
    const Job job = std::move(jobs_.front());
    jobs_.pop_front();
    underWay_ = false;
    job.end(*loaded);
  }
  if (!task_.isBusy()) beginNext();
}

void ArrangementQueue::refuse(const Diagnostic& why) {
  if (underWay_) jobs_.pop_front();
  underWay_ = false;
  if (adding_) {
    refusal_ = why;
  } else {
    emit failed(why);
  }
}

}  // namespace glissade
