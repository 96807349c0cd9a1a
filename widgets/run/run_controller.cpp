#include "widgets/run/run_controller.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QStatusBar>
#include <QStyle>
#include <QThread>

#include <algorithm>
#include <utility>

#include "engine/base/enum_names.h"
#include "engine/base/number_text.h"
#include "engine/operator/device_registry.h"
#include "engine/planning/fine/coarse_preview.h"
#include "widgets/places/rules_dialog.h"
#include "widgets/run/strategy_use.h"
#include "widgets/workbench/status_text.h"

namespace glissade {
namespace {

/// Planner steps between two checks of the state while waiting offscreen.
constexpr std::uint64_t kWaitSlice = 50;

constexpr EnumNames<SessionState, 6> kStateNames{{"idle", "planning", "paused", "solved", "stopped", "failed"}};

bool isIn(const SnapshotPtr& snapshot, const std::string& state) {
  if (!snapshot) return state == "empty";
  if (state == "ended") {
    return snapshot->state == SessionState::Solved || snapshot->state == SessionState::Failed ||
           snapshot->state == SessionState::Stopped;
  }
  return kStateNames.find(state) == snapshot->state;
}

struct NamedValue {
  ParameterId id;
  double value;
};

/// Reads a parameter's key and a value.
Result<NamedValue> parameterOf(const ScriptCommands::Words& words) {
  const auto id = parameterByKey(words[0]);
  const auto value = toNumber(words[1]);
  if (!id) return wrongCommand("there is no parameter '" + words[0] + "'");
  if (!value) return wrongCommand("'" + words[1] + "' is not a number");
  return NamedValue{*id, *value};
}

Outcome setParameter(SessionBridge& session, const ScriptCommands::Words& words) {
  const auto parameter = parameterOf(words);
  if (!parameter) return parameter.error();
  session.post(command::SetParameter{parameter->id, parameter->value});
  return Done{};
}

Outcome expectValue(const SessionBridge& session, const ScriptCommands::Words& words) {
  const auto parameter = parameterOf(words);
  if (!parameter) return parameter.error();
  if (!session.snapshot()) return wrongCommand("no scenario is open");
  const double value = valueInForce(*session.snapshot(), parameter->id);
  if (value == parameter->value) return Done{};
  return unmetExpectation(words[0] + " is " + toText(value));
}

Outcome selectOperator(SessionBridge& session, const std::string& id) {
  if (makeDeviceRegistry().find(id) == nullptr) return wrongCommand("there is no operator '" + id + "'");
  session.setDevice(id);
  return Done{};
}

Outcome selectStrategy(SessionBridge& session, const std::string& id) {
  if (makePlannerRegistry().find(id) == nullptr)
    return unknownPlanner(id, GLISSADE_TEXT("See the list of the interaction panel."));
  session.post(command::SetPlanner{id});
  return Done{};
}

Outcome wait(SessionBridge& session, const std::string& state, const std::string& until) {
  const auto limit = toNumber(until);
  if (!limit) return wrongCommand("'" + until + "' is not a limit");
  const auto reached = [&] { return isIn(session.snapshot(), state) && !session.isStarting(); };
  if (session.clock() == SessionClock::Lockstep) {
    for (auto left = static_cast<std::uint64_t>(*limit); left > 0 && !reached();) {
      const std::uint64_t slice = std::min(kWaitSlice, left);
      session.advance(slice);
      left -= slice;
    }
  } else {
    QElapsedTimer timer;
    timer.start();
    while (!reached() && static_cast<double>(timer.elapsed()) < *limit * 1000.0) {
      QApplication::processEvents(QEventLoop::AllEvents, 10);
      QThread::msleep(2);
    }
  }
  if (reached()) return Done{};
  return unmetExpectation("the session did not reach the state '" + state + "'");
}

/// Adds the script commands about parameters, strategy, operator and the state of the run.
void addRunCommands(const Workbench& bench) {
  using Words = ScriptCommands::Words;
  ScriptCommands& scripts = bench.scripts;
  SessionBridge& session = bench.session;
  scripts.add("set", 2, [&session](const Words& words) { return setParameter(session, words); });
  scripts.add("expect-value", 2, [&session](const Words& words) { return expectValue(session, words); });
  scripts.add("select-operator", 1, [&session](const Words& words) { return selectOperator(session, words[0]); });
  scripts.add("select-strategy", 1, [&session](const Words& words) { return selectStrategy(session, words[0]); });
  scripts.add("expect-strategy", 1, [&session](const Words& words) -> Outcome {
    const std::string strategy = session.snapshot() ? session.snapshot()->plannerId : "none";
    return strategy == words[0] ? Outcome(Done{}) : unmetExpectation("the strategy is " + strategy);
  });
  scripts.add("wait", 2, [&session](const Words& words) { return wait(session, words[0], words[1]); });
  scripts.add("expect", 1, [&session](const Words& words) -> Outcome {
    if (isIn(session.snapshot(), words[0])) return Done{};
    return unmetExpectation("the session is not in the state '" + words[0] + "'");
  });
}

}  // namespace

RunController::RunController(const Workbench& bench)
    : QObject(&bench.window),
      bench_(bench),
      interaction_(new InteractionPanel(&bench.window)),
      counts_(new CountsPanel(&bench.window)),
      status_(new QLabel(&bench.window)),
      elapsed_(new QLabel(&bench.window)) {
  interaction_->setHand(bench.session.hand());
  status_->setObjectName(QStringLiteral("status"));
  status_->setTextFormat(Qt::PlainText);
  status_->setText(tr("No scenario is open."));
  status_->installEventFilter(this);
  bench.window.statusBar()->addWidget(status_, 1);
  bench.window.statusBar()->addPermanentWidget(elapsed_);
  connect(&bench.document, &WorkbenchDocument::changedForSession, this, &RunController::updateSession);
  connect(&bench.document, &WorkbenchDocument::changed, this, [this](Changes what) {
    if (!(what & (Change::Scenario | Change::Arrangement))) return;
    interaction_->setScenario(*bench_.document.scenario());
    showRun(bench_.run.snapshot());  // the snapshot is one of the new session
  });
  connect(&bench.session, &SessionBridge::snapshotChanged, this,
          [this](const SnapshotPtr& snapshot) { takeSnapshot(*snapshot); });
  connect(&bench.run, &ShownRun::changed, this, &RunController::showRun);
  connect(&bench.run, &ShownRun::liveChanged, this, [this](bool live) { interaction_->setReplayed(!live); });
  connect(&bench.work, &WorkController::busyChanged, this, [this] { enableActions(bench_.run.snapshot().get()); });
  connect(interaction_, &InteractionPanel::commanded, &bench.session, &SessionBridge::post);
  connect(interaction_, &InteractionPanel::deviceChosen, this,
          [this](const QString& id) { chooseDevice(id.toStdString()); });
  connectActions();
  enableActions(nullptr);
  addRunCommands(bench);
}

bool RunController::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::LocaleChange && bench_.run.snapshot()) showRun(bench_.run.snapshot());
  return QObject::eventFilter(watched, event);
}

void RunController::connectActions() {
  bench_.onAction("run.start", this, [this] { bench_.document.whenArranged([this] { start(); }); });
  bench_.onAction("run.pause", this, [this](bool pause) {
    bench_.session.post(pause ? Command(command::Pause{}) : Command(command::Resume{}));
  });
  bench_.onAction("run.stop", this, [this] { stop(); });
  bench_.onAction("run.finish", this, [this] { finish(); });
  bench_.onAction("run.restart", this, [this] { restart(bench_.document.settings().seed); });
  bench_.onAction("run.restart-new-seed", this, [this] { restart(bench_.document.settings().seed + 1); });
  bench_.onAction("run.tuning", this, [this](bool tune) {
    bench_.session.post(command::SetParameter{ParameterId::Tuning, tune ? static_cast<double>(kTunedAll) : 0.0});
  });
  bench_.onAction("object.to-start", this,
                  [this] { bench_.session.post(command::SetDevicePose{bench_.document.scenario()->problem.start}); });
  bench_.onAction("strategy.rules", this, [this] { editRules(); });
}

void RunController::updateSession(Changes what) {
  const WorkbenchDocument& document = bench_.document;
  if (what & Change::Scenario) {
    finishing_.reset();  // its settings belong to another scenario
    ledByPerson_ = false;
    bench_.session.open(document.scenario());
  } else if (what & Change::Arrangement) {
    bench_.session.rearrange(document.scenario());
  } else if (what & Change::Semantics) {
    bench_.session.post(command::SetSemantics{document.edits()});
  }
  if ((what & Change::Knowledge) && document.knowledge()) {
    bench_.session.post(command::SetKnowledge{document.knowledge()});
  }
}

void RunController::takeSnapshot(const SessionSnapshot& snapshot) {
  keepSettings(snapshot);
  followFinish(snapshot);
  followHand(snapshot);
  bench_.document.setResults({snapshot.path, snapshot.refused, snapshot.provenance, snapshot.smoothed});
}

/// Keeps the settings in the document. What a step by hand or a run that the computer finishes has changed is kept as
/// it was before.
void RunController::keepSettings(const SessionSnapshot& snapshot) {
  RunSettings settings = finishing_.value_or(RunSettings{snapshot.plannerId, snapshot.seed, snapshot.parameters});
  if (bench_.document.isTemporary()) {
    const RunSettings& before = bench_.document.settings();
    settings.strategy = before.strategy;
    (void)settings.parameters.set(ParameterId::Pace, before.parameters[ParameterId::Pace]);
  }
  bench_.document.setSettings(settings);
}

void RunController::showRun(const SnapshotPtr& snapshot) {
  interaction_->setSnapshot(*snapshot);
  interaction_->setDevice(bench_.session.deviceId());
  counts_->setSnapshot(*snapshot, *bench_.document.scenario(), bench_.session.clock());
  status_->setText(bench_.run.isLive() ? stateText(*snapshot) : bench_.run.replayText());
  markFound(bench_.run.isLive() && snapshot->state == SessionState::Solved && snapshot->run > 0);
  elapsed_->setText(snapshot->run > 0 ? elapsedText(*snapshot) : QString());
  enableActions(snapshot.get());
}

/// Lets the style sheet mark that a path was found.
void RunController::markFound(bool found) {
  if (status_->property("found").toBool() == found) return;
  status_->setProperty("found", found);
  status_->style()->unpolish(status_);
  status_->style()->polish(status_);
}

QString RunController::stateText(const SessionSnapshot& snapshot) const {
  const LoadedScenario& scenario = *bench_.document.scenario();
  const bool isProduct = std::holds_alternative<GoalOut>(scenario.problem.goal);
  if (!isProduct || snapshot.state != SessionState::Idle || snapshot.problem || snapshot.refused) {
    return statusText(snapshot);
  }
  const auto key = [this](const char* id) {
    return bench_.actions[QLatin1String(id)]->shortcut().toString(QKeySequence::NativeText);
  };
  if (scenario.obstacles.empty() && scenario.objectBodies.size() == 1) {
    return tr("Ready. The file is one part: a sequence needs two parts or more.");
  }
  return tr("Ready. Plan sequence (%1) is for all parts, Find path (%2) for the moving part.")
      .arg(key("sequence.plan"), key("run.start"));
}

void RunController::enableActions(const SessionSnapshot* snapshot) {
  const bool live = snapshot != nullptr && bench_.run.isLive();
  const bool running = live && isRunning(*snapshot);
  bench_.enable("run.start", live && !running);
  bench_.enable("run.pause", running);
  bench_.enable("run.stop", running || bench_.work.isBusy());
  bench_.enable("run.finish", running && ledByPerson_ && !finishing_);
  for (const char* id : {"run.restart", "run.restart-new-seed", "run.tuning", "object.to-start"}) {
    bench_.enable(id, live);
  }
  bench_.enable("strategy.rules", live && !running);
  const bool tuned = snapshot != nullptr && snapshot->parameters[ParameterId::Tuning] > 0.0;
  bench_.actions["run.tuning"]->setChecked(tuned);
  bench_.actions["run.pause"]->setChecked(live && snapshot->state == SessionState::Paused);
}

/// Chooses the device, and a strategy that uses it: a person who takes the object in hand wants to take part in the
/// search.
void RunController::chooseDevice(const std::string& id) {
  bench_.session.setDevice(id);
  const std::string& strategy = bench_.document.settings().strategy;
  const std::string withHand = strategyWithHand(strategy, id);
  if (withHand != strategy) bench_.session.post(command::SetPlanner{withHand});
}

void RunController::restart(std::uint64_t seed) {
  bench_.document.whenArranged([this, seed] {
    bench_.session.post(command::Stop{});
    bench_.session.post(command::SetSeed{seed});
    start();
  });
}

void RunController::start() {
  bench_.session.post(command::Stop{});  // a smoothing may still be running
  if (!bench_.document.isTemporary()) {
    const bool hasCoarsePlan = isMultiLayer(bench_.document.settings().strategy);
    QWidget* focus = QApplication::focusWidget();
    bench_.bringToFront(Workspace::Planning, hasCoarsePlan ? "panel.plan" : "panel.run");
    if (ledByPerson_) focus = bench_.scene.widget();  // its keys steer the object
    if (focus != nullptr) focus->setFocus();
  }
  bench_.session.post(command::Start{ledByPerson_});
}

void RunController::stop() {
  const SnapshotPtr& snapshot = bench_.run.snapshot();
  if (snapshot && bench_.run.isLive() && isRunning(*snapshot)) {
    bench_.session.post(command::Stop{});
  } else {
    bench_.work.cancelShown();
  }
}

/// The strategy by hand goes on from the way of the hand. Algorithm 1 keeps no way, and would go on as a plain BiRRT:
/// the strategy "auto" begins in its place.
void RunController::finish() {
  const SessionSnapshot& now = *bench_.session.snapshot();
  const bool keepsWay = now.plannerId == "by-hand" || now.plannerId == "interactive";
  finishing_ = {now.plannerId, now.seed, now.parameters};
  finishingRun_ = keepsWay ? now.run : now.run + 1;
  if (!keepsWay) {
    bench_.session.post(command::Stop{});
    bench_.session.post(command::SetPlanner{"auto"});
  }
  bench_.session.post(command::SetParameter{ParameterId::Pace, 0.0});
  bench_.session.post(command::SetParameter{ParameterId::Alpha, 1.0});
  if (!keepsWay) bench_.session.post(command::Start{});
}

void RunController::followFinish(const SessionSnapshot& snapshot) {
  if (!finishing_ || isRunning(snapshot) || snapshot.run < finishingRun_) return;
  const RunSettings settings = *std::exchange(finishing_, std::nullopt);
  const ParameterValues& before = settings.parameters;
  if (snapshot.plannerId != settings.strategy) {
    QMetaObject::invokeMethod(
        this, [this, id = settings.strategy] { bench_.session.post(command::SetPlanner{id}); }, Qt::QueuedConnection);
  }
  // Setting alpha ends its tuning, so that the tuning comes last.
  for (const ParameterId id : {ParameterId::Alpha, ParameterId::Pace, ParameterId::Tuning}) setLater(id, before[id]);
}

void RunController::setLater(ParameterId id, double value) {
  // A snapshot is being announced, and setting a parameter announces the next one.
  QMetaObject::invokeMethod(
      this,
      [this, id, value] {
        bench_.session.post(command::SetParameter{id, value});
      },
      Qt::QueuedConnection);
}

void RunController::followHand(const SessionSnapshot& snapshot) {
  const bool before = std::exchange(ledByPerson_, isLedByPerson(snapshot.plannerId, bench_.session.deviceId()));
  if (before == ledByPerson_ || bench_.session.clock() == SessionClock::Lockstep) return;
  const double pace = snapshot.parameters[ParameterId::Pace];
  const double ofPerson = snapshot.parameters[ParameterId::StepsPerSecond];
  if (ledByPerson_ && pace == 0.0) {
    setLater(ParameterId::Pace, ofPerson);
  } else if (before && pace == ofPerson) {
    setLater(ParameterId::Pace, 0.0);
  }
}

void RunController::editRules() {
  const std::optional<StrategyRules>& own = bench_.document.scenario()->scenario.rules;
  const std::string& strategy = bench_.document.settings().strategy;
  const bool preset = strategy == "gt" || strategy == "gts1" || strategy == "gts2";
  RulesDialog dialog(preset ? presetRules(strategy)
                     : own  ? *own
                            : presetRules("gts"),
                     bench_.document.semantics().table(), &bench_.window);
  if (dialog.exec() != QDialog::Accepted) return;
  const auto change = [rules = dialog.rules()](Scenario& scenario) {
    scenario.rules = rules;
    return Outcome(Done{});
  };
  const Outcome changed = bench_.document.edit(tr("Change the rules"), change);
  if (!changed) bench_.messages.showError(tr("The rules cannot be changed"), changed.error());
  bench_.document.whenArranged([this] { bench_.session.post(command::SetPlanner{"own"}); });
}

}  // namespace glissade
