#include "widgets/document/replay_runner.h"

#include <chrono>
#include <functional>

namespace glissade {
namespace {

constexpr std::chrono::milliseconds kReportInterval{50};
/// Session steps between two readings of the clock.
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

void ReplayRunner::cancel() {
  ++request_;
  task_.cancel();
}

void ReplayRunner::deliver(std::uint64_t request, const Result<ReplayProgress>& result) {
  if (request != request_) return;
  if (result) {
    emit progressed(*result);
  } else {
    emit failed(result.error());
  }
}

void ReplayRunner::run(const Problem& problem, const std::shared_ptr<const RunLog>& log, ReplayEnd end, bool atOnce) {
  cancel();
  // The work reports its progress and result while it runs; the delivery at its end is empty.
  const auto work = [this, problem, log, end, atOnce, request = request_](const WorkWatch& watch) {
    replay(problem, log, end, watch.stop, [this, atOnce, request](const Result<ReplayProgress>& result) {
      QMetaObject::invokeMethod(
          this, [this, request, result] { deliver(request, result); },
          atOnce ? Qt::DirectConnection : Qt::QueuedConnection);
    });
    return [] {};
  };
  task_.start(GLISSADE_TEXT("replaying the recording"), work, atOnce);
}

}  // namespace glissade
