#include "widgets/bridge/replay_runner.h"

#include <chrono>
#include <functional>

namespace glissade {
namespace {

constexpr std::chrono::milliseconds kReportInterval{50};
/// Session steps between two looks at the clock.
constexpr std::uint64_t kSlice = 200;

using Report = std::function<void(const Result<ReplayProgress>&)>;

void replay(const Problem& problem, const std::shared_ptr<const RunLog>& log, ReplayEnd end, const StopToken& stop,
            const Report& report) {
  const auto prepared = withRecordedKnowledge(problem, *log, stop);
  if (!prepared) {
    report(prepared.error());
    return;
  }
  const auto session = makeReplaySession(*prepared, log, end);
  session->post(command::Start{});
  session->advance(0);
  auto reported = std::chrono::steady_clock::now();
  while (isRunning(*session->snapshot()) && !stop.stopRequested()) {
    session->advance(kSlice, stop);
    const auto now = std::chrono::steady_clock::now();
    if (now - reported < kReportInterval) continue;
    reported = now;
    report(ReplayProgress{session->snapshot(), session->track(), false});
  }
  report(ReplayProgress{session->snapshot(), session->track(), true});
}

}  // namespace

ReplayRunner::~ReplayRunner() {
  cancel();
  for (Worker& worker : workers_) worker.thread.join();
}

void ReplayRunner::cancel() {
  ++request_;
  stop_.requestStop();
}

void ReplayRunner::joinFinished() {
  for (auto worker = workers_.begin(); worker != workers_.end();) {
    if (!worker->done) {
      ++worker;
      continue;
    }
    worker->thread.join();
    worker = workers_.erase(worker);
  }
}

void ReplayRunner::run(const Problem& problem, const std::shared_ptr<const RunLog>& log, ReplayEnd end, bool atOnce) {
  cancel();
  joinFinished();
  stop_ = StopSource();
  const auto deliver = [this, request = request_](const Result<ReplayProgress>& result) {
    if (request != request_) return;
    if (result) {
      emit progressed(*result);
    } else {
      emit failed(result.error());
    }
  };
  if (atOnce) {
    replay(problem, log, end, stop_.token(), deliver);
    return;
  }
  Worker& worker = workers_.emplace_back();
  worker.thread = std::thread([this, deliver, problem, log, end, stop = stop_.token(), done = &worker.done] {
    replay(problem, log, end, stop, [this, &deliver](const Result<ReplayProgress>& result) {
      QMetaObject::invokeMethod(
          this, [deliver, result] { deliver(result); }, Qt::QueuedConnection);
    });
    *done = true;
  });
}

}  // namespace glissade
