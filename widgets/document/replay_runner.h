#pragma once

#include "engine/session/replay_session.h"
#include "widgets/controls/background_task.h"

namespace glissade {

/// Progress of a replay. The roadmap only grows, so any step replayed so far can be shown.
struct ReplayProgress {
  SnapshotPtr latest;
  std::shared_ptr<const ReplayTrack> track;
  bool ended = false;
};

/// Replays a recorded run in a thread of its own, or at once where time is not real. A new request or cancel() asks the
/// replay under way to stop and forgets it; the destructor waits.
class ReplayRunner final : public QObject {
  Q_OBJECT

 public:
  explicit ReplayRunner(QObject* parent = nullptr) : QObject(parent) {
    connect(&task_, &BackgroundTask::failed, this, &ReplayRunner::failed);
  }

  /// `atOnce`: the replay has ended before this function returns.
  void run(const Problem& problem, const std::shared_ptr<const RunLog>& log, ReplayEnd end, bool atOnce);
  void cancel();

 signals:
  /// Emitted some twenty times a second, and at the end.
  void progressed(const glissade::ReplayProgress& progress);
  /// The replay failed, or an exception has ended it.
  void failed(const glissade::Diagnostic& why);

 private:
  void deliver(std::uint64_t request, const Result<ReplayProgress>& result);

  std::uint64_t request_ = 0;
  BackgroundTask task_;
};

}  // namespace glissade
