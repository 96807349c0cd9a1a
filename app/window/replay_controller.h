#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>

#include "app/window/workbench.h"
#include "engine/session/replay_view.h"
#include "widgets/bridge/replay_runner.h"
#include "widgets/bridge/run_recorder.h"
#include "widgets/panels/replay_bar.h"

namespace glissade {

/// Recordings: every run is recorded, a recording is saved, opened and replayed. A replay runs to its
/// end in the background while any step of it is shown.
class ReplayController final : public QObject {
  Q_OBJECT

 public:
  explicit ReplayController(const Workbench& bench);

  RunRecorder& recorder() { return recorder_; }
  ReplayBar* bar() const { return bar_; }
  /// What is shown is a replay.
  bool isActive() const { return log_ != nullptr; }

  /// Opens a recording that was read from a file; `openOther` opens its scenario where another is open.
  std::optional<Diagnostic> open(const RunRecord& record, const QString& file,
                                 const std::function<std::optional<Diagnostic>(const QString&)>& openOther);
  SaveResult save(const QString& file);
  void close();

  /// Shows another step, as far as it is replayed.
  void seek(std::uint64_t step);
  std::uint64_t step() const { return step_; }
  /// "same", "different" or "another" once the replay has ended; empty before.
  const std::string& verdict() const { return verdict_; }

 private:
  /// After a change the next run is of the document's scenario; of the same one with its bodies elsewhere, the
  /// recording of the last run can still be saved.
  void followDocument(Changes what);
  void followRun(const SessionSnapshot& snapshot);
  void showError(const Diagnostic& why);
  void connectActions();
  void enableActions();
  /// The last run or the recording that is open.
  Result<RunLog> lastLog();
  void start(RunLog log, ReplayEnd end);
  void replayLast();
  void replayWithCurrentParameters();
  void takeProgress(const ReplayProgress& progress);
  void judge();
  void showVerdict(const std::string& verdict, const QString& inShort, const QString& inWords);
  void play(bool playing);
  void tick();
  void show();
  std::uint64_t steps() const;

  const Workbench& bench_;
  RunRecorder recorder_;
  ReplayRunner runner_;
  ReplayBar* bar_;
  std::optional<RunLog> opened_;       ///< of the recording opened last
  std::shared_ptr<const RunLog> log_;  ///< of the replay shown; null: none
  ReplayEnd end_ = ReplayEnd::WithTheLog;
  ReplayProgress progress_;
  std::unique_ptr<ReplayView> view_;
  std::uint64_t number_ = 0;  ///< of the replay
  std::uint64_t step_ = 0;
  std::string verdict_;
  QString statusText_;
  QTimer timer_;
  QElapsedTimer sinceTick_;
  double seconds_ = 0.0;  ///< of the run, where playback is
};

}  // namespace glissade
