#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>

#include "engine/session/replay_view.h"
#include "widgets/bridge/replay_runner.h"
#include "widgets/bridge/run_recorder.h"
#include "widgets/commands/action_catalogue.h"
#include "widgets/panels/replay_bar.h"

namespace glissade {

/// Recordings: every run is recorded, a recording is saved, opened and replayed. A replay runs to its
/// end in the background while any step of it is shown. Part of the main window.
class ReplayController final : public QObject {
  Q_OBJECT

 public:
  ReplayController(SessionBridge& bridge, const ActionCatalogue& actions, QWidget* window);

  RunRecorder& recorder() { return recorder_; }
  ReplayBar* bar() const { return bar_; }
  /// What is shown is a replay.
  bool isActive() const { return log_ != nullptr; }

  void openScenario(const ScenarioPtr& scenario);
  /// Its bodies are elsewhere from the next run on; the recording of the last one can still be saved.
  void rearrange(const ScenarioPtr& scenario);
  /// Opens a recording that was read from a file; `openScenario` is asked for its scenario where another is open.
  std::optional<Diagnostic> open(const RunRecord& record, const QString& file,
                                 const std::function<std::optional<Diagnostic>(const QString&)>& openOther);
  std::optional<Diagnostic> save(const QString& file);
  void close();

  /// Shows another step, as far as it is replayed.
  void seek(std::uint64_t step);
  std::uint64_t step() const { return step_; }
  /// "same", "different" or "another" once the replay has ended; empty before.
  const std::string& verdict() const { return verdict_; }
  /// The same in words.
  const QString& statusText() const { return statusText_; }

 signals:
  /// What the window is to show while a replay is open.
  void shown(const glissade::SnapshotPtr& snapshot);
  /// A replay was opened, or the session is shown again.
  void activeChanged(bool active);
  void failed(const glissade::Diagnostic& why);
  /// The run goes on, but a killed program would lose its recording.
  void notJournalled(const glissade::Diagnostic& why);

 private:
  void connectActions();
  void enableActions();
  /// The last run or the recording that is open.
  Result<RunLog> lastLog();
  void start(RunLog log, ReplayEnd end);
  void replayLast();
  void replayWithCurrentParameters();
  void take(const ReplayProgress& progress);
  void judge();
  void say(const std::string& verdict, const QString& inShort, const QString& inWords);
  void play(bool playing);
  void tick();
  void show();
  std::uint64_t steps() const;

  SessionBridge& bridge_;
  const ActionCatalogue& actions_;
  RunRecorder recorder_;
  ReplayRunner runner_;
  ReplayBar* bar_;
  ScenarioPtr scenario_;
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
