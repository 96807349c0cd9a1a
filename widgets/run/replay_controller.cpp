#include "widgets/run/replay_controller.h"

#include <QFileInfo>
#include <QLocale>

#include <algorithm>

#include "engine/base/number_text.h"
#include "engine/files/run_record.h"
#include "engine/files/same_problem.h"
#include "engine/session/run_comparison.h"
#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/length_text.h"
#include "widgets/workbench/script_commands.h"

namespace glissade {
namespace {

Outcome seek(ReplayController& replay, const std::string& word) {
  const auto step = toNumber(word);
  if (!step || *step < 0) return wrongCommand("'" + word + "' is not a step");
  if (!replay.isActive()) return wrongCommand("no replay is open");
  replay.seek(static_cast<std::uint64_t>(*step));
  return Done{};
}

Outcome expectReplay(const ReplayController& replay, const std::string& verdict) {
  const std::string found = replay.isActive() ? replay.verdict() : "closed";
  if (found == verdict) return Done{};
  return unmetExpectation("the replay is " + (found.empty() ? "still running" : found) + ", not " + verdict);
}

/// Adds the script commands about recordings and replays.
void addReplayCommands(ScriptCommands& scripts, ReplayController& replay) {
  using Words = ScriptCommands::Words;
  scripts.add("save-recording", 1,
              [&replay](const Words& words) { return outcomeOf(replay.save(QString::fromStdString(words[0]))); });
  scripts.add("seek", 1, [&replay](const Words& words) { return seek(replay, words[0]); });
  scripts.add("expect-replay", 1, [&replay](const Words& words) { return expectReplay(replay, words[0]); });
}

constexpr int kTickMilliseconds = 16;
/// Number of ticks of a whole run at full speed (two seconds).
constexpr std::uint64_t kTicksOfAWholeRun = 120;
/// A replay with other parameters ends at the latest after this multiple of the run's steps.
constexpr std::uint64_t kPatience = 10;
constexpr std::uint64_t kLeastSteps = 1000;

/// Whether the record belongs to the scenario. Records of version 1 identify their scenario only by its file.
bool isOf(const RunRecord& record, const ScenarioPtr& scenario) {
  if (!scenario) return false;
  if (record.version > 1) return isRecordOf(record, *scenario);
  return QFileInfo(QString::fromStdString(record.scenario)) == QFileInfo(QString::fromStdString(scenario->file));
}

}  // namespace

ReplayController::ReplayController(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), bar_(new ReplayBar(bench.actions, &bench.window)) {
  bench.window.addToolBar(Qt::BottomToolBarArea, bar_);
  bar_->hide();
  timer_.setInterval(kTickMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &ReplayController::tick);
  connect(bar_, &ReplayBar::stepChosen, this, &ReplayController::seek);
  connect(&runner_, &ReplayRunner::progressed, this, &ReplayController::takeProgress);
  connect(&runner_, &ReplayRunner::failed, this, [this](const Diagnostic& why) {
    close();
    showError(why);
  });
  connect(&bench.document, &WorkbenchDocument::changed, this, &ReplayController::followDocument);
  connect(&bench.session, &SessionBridge::snapshotChanged, this,
          [this](const SnapshotPtr& snapshot) { followRun(*snapshot); });
  connectActions();
  enableActions();
  addReplayCommands(bench.scripts, *this);
}

void ReplayController::followDocument(Changes what) {
  const ScenarioPtr& scenario = bench_.document.scenario();
  if (!(what & (Change::Scenario | Change::Arrangement))) {
    if (what & Change::File) recorder_.renew(scenario);
    return;
  }
  close();
  opened_.reset();
  if (what & Change::Scenario) {
    recorder_.open(scenario);
  } else {
    recorder_.rearrange(scenario);
  }
  enableActions();
}

void ReplayController::followRun(const SessionSnapshot& snapshot) {
  if (recorder_.follow(snapshot)) opened_.reset();
  if (const auto why = recorder_.takeTrouble()) {
    bench_.messages.showStatus(tr("No journal of this run on disk: %1").arg(diagnosticLine(*why)));
  }
  enableActions();
}

void ReplayController::showError(const Diagnostic& why) {
  bench_.messages.showError(tr("The recording cannot be replayed"), why);
}

void ReplayController::connectActions() {
  const auto on = [this](const char* id, auto handler) { bench_.onAction(id, this, handler); };
  on("replay.last", [this] { replayLast(); });
  on("replay.again", [this] { replayWithCurrentParameters(); });
  on("replay.close", [this] { close(); });
  on("replay.to-start", [this] { seek(0); });
  on("replay.step", [this] { seek(step_ + (progress_.track ? progress_.track->stride() : 1)); });
  on("replay.step-back", [this] {
    const std::uint64_t stride = progress_.track ? progress_.track->stride() : 1;
    seek(step_ - std::min(step_, stride));
  });
  connect(bench_.actions["replay.play"], &QAction::toggled, this, &ReplayController::play);
}

void ReplayController::enableActions() {
  const auto enable = [this](const char* id, bool enabled) { bench_.enable(id, enabled); };
  const SnapshotPtr live = bench_.session.snapshot();
  const bool running = live && isRunning(*live);
  const bool recorded = recorder_.hasRecording() || opened_;
  enable("file.save-recording", recorder_.hasRecording() && !isActive());
  enable("file.open-recording", !running);
  enable("replay.last", recorded && !running);
  enable("replay.again", recorded && !running);
  for (const char* id : {"replay.play", "replay.step", "replay.step-back", "replay.to-start", "replay.close"}) {
    enable(id, isActive());
  }
}

std::optional<Diagnostic> ReplayController::open(
    const RunRecord& record, const QString& file,
    const std::function<std::optional<Diagnostic>(const QString&)>& openOther) {
  const ScenarioPtr before = bench_.document.scenario();
  if (!isOf(record, before) || before->fitsPending) {
    if (auto why = openOther(QString::fromStdString(record.scenario))) return why;
    if (bench_.document.scenario() == before) return std::nullopt;  // the user keeps the open scenario
  }
  auto log = replayLog(record, *bench_.document.scenario(), file.toStdString());
  if (!log) return log.error();
  opened_ = *log;
  start(std::move(*log), ReplayEnd::WithTheLog);
  return std::nullopt;
}

SaveResult ReplayController::save(const QString& file) {
  if (!recorder_.hasRecording()) {
    return notSaved({ErrorKind::Usage, file.toStdString(), "", GLISSADE_TEXT("there is no run to save"),
                     GLISSADE_TEXT("Start one first.")});
  }
  const auto record = recorder_.record();
  return record ? writeRunRecord(*record, file.toStdString()) : notSaved(record.error());
}

Result<RunLog> ReplayController::lastLog() {
  if (opened_) return *opened_;
  auto record = recorder_.record();
  if (!record) return record.error();
  return replayLog(*record, *bench_.document.scenario(), "");
}

void ReplayController::replayLast() {
  auto log = lastLog();
  if (log) {
    start(std::move(*log), ReplayEnd::WithTheLog);
  } else {
    showError(log.error());
  }
}

void ReplayController::replayWithCurrentParameters() {
  auto log = lastLog();
  if (!log) {
    showError(log.error());
    return;
  }
  const SnapshotPtr live = bench_.session.snapshot();
  for (const ParameterSpec& spec : parameterTable()) {
    if (spec.live) overrideParameter(spec.id, live->parameters[spec.id], *log);
  }
  if (log->start.parameters[ParameterId::MaxSteps] == 0.0) {
    const std::uint64_t steps = std::max(kLeastSteps, kPatience * (log->end ? log->end->step : 0));
    overrideParameter(ParameterId::MaxSteps, std::min(1e9, static_cast<double>(steps)), *log);
  }
  start(std::move(*log), ReplayEnd::Continue);
}

void ReplayController::start(RunLog log, ReplayEnd end) {
  play(false);
  log_ = std::make_shared<const RunLog>(std::move(log));
  end_ = end;
  progress_ = {};
  view_.reset();
  ++number_;
  step_ = 0;
  seconds_ = 0.0;
  showVerdict("", tr("replaying..."), tr("The run is being replayed"));
  bar_->show();
  bench_.run.beginReplay();
  enableActions();
  runner_.run(bench_.document.scenario()->problem, log_, end, bench_.session.clock() == SessionClock::Lockstep);
}

void ReplayController::close() {
  if (!isActive()) return;
  runner_.cancel();
  play(false);
  log_.reset();
  view_.reset();
  progress_ = {};
  bar_->hide();
  enableActions();
  bench_.run.endReplay();
}

std::uint64_t ReplayController::steps() const {
  const std::uint64_t replayed = progress_.track ? progress_.track->lastStep() : 0;
  const bool known = end_ == ReplayEnd::WithTheLog && log_->end && !progress_.ended;
  return known ? std::max(log_->end->step, replayed) : replayed;
}

void ReplayController::takeProgress(const ReplayProgress& progress) {
  if (!isActive()) return;
  progress_ = progress;
  if (!view_) view_ = std::make_unique<ReplayView>(bench_.document.scenario()->problem, log_, progress.track, number_);
  if (progress.ended) {
    judge();
  } else if (steps() > 0) {
    const std::uint64_t percent = 100 * progress_.track->lastStep() / steps();
    showVerdict("", tr("replaying... %1 %").arg(percent), tr("The run is being replayed"));
  }
  show();
}

void ReplayController::judge() {
  const RunLogParts& parts = progress_.latest->log;
  const RunLog again = parts.empty() ? RunLog() : joined(parts);
  const std::uint64_t nodes = progress_.latest->counts.nodes;
  const RunCheckpoint recorded = log_->end.value_or(RunCheckpoint{});
  if (end_ == ReplayEnd::Continue) {
    const bool solved = progress_.latest->state == SessionState::Solved;
    showVerdict("another", tr("other parameters"),
                (solved ? tr("Other parameters: solved, %1 nodes (recorded: %2)")
                        : tr("Other parameters: no path, %1 nodes (recorded: %2)"))
                    .arg(countText(nodes), countText(recorded.nodes)));
  } else if (const auto difference = firstDifference(*log_, again)) {
    showVerdict("different", tr("≠ recorded"),
                tr("Differs from the recording: the same until step %1, not at step %2")
                    .arg(countText(difference->same), countText(difference->recorded.step)));
  } else {
    showVerdict("same", tr("✓ as recorded"), tr("Same roadmap as recorded: %1 nodes").arg(countText(recorded.nodes)));
  }
}

void ReplayController::showVerdict(const std::string& verdict, const QString& inShort, const QString& inWords) {
  verdict_ = verdict;
  statusText_ = tr("Replay. %1").arg(inWords);
  bar_->setVerdict(inShort, inWords, verdict == "different");
}

void ReplayController::seek(std::uint64_t step) {
  if (!isActive()) return;
  step_ = std::min(step, progress_.track ? progress_.track->lastStep() : 0);
  seconds_ = secondsAt(*log_, step_);
  show();
}

void ReplayController::play(bool playing) {
  bench_.actions["replay.play"]->setChecked(playing);
  if (!playing) {
    timer_.stop();
    return;
  }
  if (progress_.ended && step_ >= steps()) seek(0);
  sinceTick_.start();
  timer_.start();
}

void ReplayController::tick() {
  const double passed = static_cast<double>(sinceTick_.restart()) / 1000.0;
  if (!progress_.track) return;
  std::uint64_t next = step_ + std::max<std::uint64_t>(1, steps() / kTicksOfAWholeRun);
  if (bar_->speed() > 0.0) {
    seconds_ += passed * bar_->speed();
    next = stepAt(*log_, seconds_);
  }
  const std::uint64_t before = step_;
  step_ = std::min(next, progress_.track->lastStep());
  if (step_ < next || bar_->speed() == 0.0) seconds_ = secondsAt(*log_, step_);
  if (step_ != before) show();
  if (progress_.ended && step_ >= steps()) play(false);
}

void ReplayController::show() {
  bar_->setPlace(step_, steps(), secondsAt(*log_, step_));
  if (!view_) return;
  const bool end = progress_.ended && step_ >= progress_.track->lastStep();
  bench_.run.showReplay(view_->at(step_, *progress_.latest, end), statusText_);
}

}  // namespace glissade
