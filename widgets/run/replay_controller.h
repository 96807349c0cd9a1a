#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>

#include "engine/session/replay_view.h"
#include "widgets/document/replay_runner.h"
#include "widgets/document/run_recorder.h"
#include "widgets/run/replay_bar.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// Recordings: records every run; saves, opens and replays recordings. A replay runs to its end in the background, and
/// any replayed step can be shown.
class ReplayController final : public QObject {
  Q_OBJECT

 public:
  explicit ReplayController(const Workbench& bench);

  RunRecorder& recorder() { return recorder_; }
  ReplayBar* bar() const { return bar_; }
  /// Whether a replay is shown.
  bool isActive() const { return log_ != nullptr; }

  /// Opens a recording read from a file; `openOther` opens its scenario if another is open.
  std::optional<Diagnostic> open(const RunRecord& record, const QString& file,
                                 const std::function<std::optional<Diagnostic>(const QString&)>& openOther);
  SaveResult save(const QString& file);
  void close();

  /// Shows another step, at most the last replayed one.
  void seek(std::uint64_t step);
  std::uint64_t step() const { return step_; }
  /// "same", "different" or "another" after the end of the replay; empty before.
  const std::string& verdict() const { return verdict_; }

 private:
  /// Follows changes of the document. After a change the next run is one of the document's scenario. If only bodies
  /// were moved, the recording of the last run can still be saved.
  void followDocument(Changes what);
  void followRun(const SessionSnapshot& snapshot);
  void showError(const Diagnostic& why);
  void connectActions();
  void enableActions();
  /// The log of the last run, or of the opened recording.
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
  std::optional<RunLog> opened_;       ///< log of the recording opened last
  std::shared_ptr<const RunLog> log_;  ///< log of the shown replay; null: none
  ReplayEnd end_ = ReplayEnd::WithTheLog;
  ReplayProgress progress_;
  std::unique_ptr<ReplayView> view_;
  std::uint64_t number_ = 0;  ///< number of the replay
  std::uint64_t step_ = 0;
  std::string verdict_;
  QString statusText_;
  QTimer timer_;
  QElapsedTimer sinceTick_;
  double seconds_ = 0.0;  ///< time of the run that the playback has reached
};

}  // namespace glissade
