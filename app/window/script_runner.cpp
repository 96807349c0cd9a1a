#include "app/window/script_runner.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QImage>
#include <QKeyEvent>
#include <QKeySequence>
#include <QThread>

#include <algorithm>
#include <map>

#include "app/window/assembly_script.h"
#include "app/window/device_controller.h"
#include "app/window/device_script.h"
#include "app/window/difficulty_script.h"
#include "app/window/environment_script.h"
#include "app/window/path_script.h"
#include "app/window/replay_script.h"
#include "app/window/study_script.h"
#include "engine/base/number_text.h"
#include "engine/operator/device_registry.h"

namespace glissade {
namespace {

/// Planner steps between two looks at the state while waiting offscreen.
constexpr std::uint64_t kSlice = 50;

const std::map<std::string, SessionState>& states() {
  static const std::map<std::string, SessionState> byName{
      {"idle", SessionState::Idle},     {"planning", SessionState::Planning}, {"paused", SessionState::Paused},
      {"solved", SessionState::Solved}, {"stopped", SessionState::Stopped},   {"failed", SessionState::Failed}};
  return byName;
}

}  // namespace

std::optional<Diagnostic> ScriptRunner::run(const std::vector<ScriptCommand>& commands) {
  for (const ScriptCommand& command : commands) {
    if (command.name == "quit") break;
    const Outcome outcome = carryOut(command);
    if (!outcome) return outcome.error();
    QApplication::processEvents();
  }
  return std::nullopt;
}

Diagnostic ScriptRunner::wrong(const ScriptCommand& command, const std::string& reason,
                               const std::string& advice) const {
  return {ErrorKind::MalformedInput, file_, "line " + std::to_string(command.line), reason, advice};
}

Diagnostic ScriptRunner::failed(const ScriptCommand& command, const std::string& reason) const {
  Diagnostic why = wrong(command, reason);
  why.kind = ErrorKind::NoPath;
  return why;
}

Outcome ScriptRunner::carryOut(const ScriptCommand& command) {
  const QString first = command.arguments.empty() ? QString() : QString::fromStdString(command.arguments[0]);
  if (command.name == "action") return trigger(command);
  if (command.name == "set") return setParameter(command);
  if (command.name == "expect-value") return expectValue(command);
  if (command.name == "key") return key(command);
  if (command.name == "steps") return steps(command);
  if (command.name == "wait") return wait(command);
  if (command.name == "expect") return expect(command);
  if (command.name == "select-operator") {
    if (makeDeviceRegistry().find(command.arguments[0]) == nullptr) return wrong(command, "there is no such operator");
    window_.bridge().setDevice(command.arguments[0]);
    return Done{};
  }
  if (command.name == "open") return open(command);
  if (command.name == "save") return save(command);
  if (command.name == "select-strategy") return selectStrategy(command);
  if (const auto outcome = EnvironmentScript(window_).carryOut(command)) {
    return *outcome ? Outcome(Done{}) : atLine(command, outcome->error());
  }
  if (const auto outcome = AssemblyScript(window_).carryOut(command)) {
    return *outcome ? Outcome(Done{}) : atLine(command, outcome->error());
  }
  if (const auto outcome = DeviceScript(window_).carryOut(command)) {
    return *outcome ? Outcome(Done{}) : atLine(command, outcome->error());
  }
  if (const auto outcome = ReplayScript(window_).carryOut(command)) {
    return *outcome ? Outcome(Done{}) : atLine(command, outcome->error());
  }
  if (const auto outcome = DifficultyScript(window_).carryOut(command)) {
    return *outcome ? Outcome(Done{}) : atLine(command, outcome->error());
  }
  if (const auto outcome = StudyScript(window_).carryOut(command)) {
    return *outcome ? Outcome(Done{}) : atLine(command, outcome->error());
  }
  if (const auto outcome = PathScript(window_).carryOut(command)) {
    return *outcome ? Outcome(Done{}) : atLine(command, outcome->error());
  }
  if (!window_.picture().save(first)) return wrong(command, "the picture cannot be saved", "Check the folder.");
  return Done{};
}

/// An error of the program, at this line of the script.
Diagnostic ScriptRunner::atLine(const ScriptCommand& command, Diagnostic why) const {
  const std::string detail = why.place.empty() ? "" : why.place + ": ";
  return {why.kind, file_, "line " + std::to_string(command.line), detail + why.reason, why.advice};
}

Outcome ScriptRunner::open(const ScriptCommand& command) {
  const auto why = window_.openScenario(QString::fromStdString(command.arguments[0]), true);
  return why ? Outcome(atLine(command, *why)) : Outcome(Done{});
}

Outcome ScriptRunner::save(const ScriptCommand& command) {
  if (!window_.bridge().snapshot()) return wrong(command, "no scenario is open");
  const auto why = window_.saveScenarioAs(QString::fromStdString(command.arguments[0]));
  return why ? Outcome(atLine(command, *why)) : Outcome(Done{});
}

Outcome ScriptRunner::selectStrategy(const ScriptCommand& command) {
  if (makePlannerRegistry().find(command.arguments[0]) == nullptr) return wrong(command, "there is no such strategy");
  window_.bridge().post(command::SetPlanner{command.arguments[0]});
  return Done{};
}

Outcome ScriptRunner::trigger(const ScriptCommand& command) {
  QAction* action = window_.actions().find(QString::fromStdString(command.arguments[0]));
  if (action == nullptr) return wrong(command, "there is no action '" + command.arguments[0] + "'");
  if (!action->isEnabled()) return wrong(command, "the action '" + command.arguments[0] + "' is not possible now");
  action->trigger();
  return Done{};
}

Outcome ScriptRunner::setParameter(const ScriptCommand& command) {
  const auto id = parameterByKey(command.arguments[0]);
  const auto value = toNumber(command.arguments[1]);
  if (!id) return wrong(command, "there is no parameter '" + command.arguments[0] + "'");
  if (!value) return wrong(command, "'" + command.arguments[1] + "' is not a number");
  window_.bridge().post(command::SetParameter{*id, *value});
  return Done{};
}

Outcome ScriptRunner::expectValue(const ScriptCommand& command) {
  const auto id = parameterByKey(command.arguments[0]);
  const auto wanted = toNumber(command.arguments[1]);
  const SnapshotPtr snapshot = window_.bridge().snapshot();
  if (!id) return wrong(command, "there is no parameter '" + command.arguments[0] + "'");
  if (!wanted) return wrong(command, "'" + command.arguments[1] + "' is not a number");
  if (!snapshot) return wrong(command, "no scenario is open");
  const double value = valueInForce(*snapshot, *id);
  if (value == *wanted) return Done{};
  return failed(command, command.arguments[0] + " is " + toText(value));
}

Outcome ScriptRunner::key(const ScriptCommand& command) {
  const QKeySequence sequence(QString::fromStdString(command.arguments[1]));
  if (sequence.count() != 1) return wrong(command, "there is no key '" + command.arguments[1] + "'");
  const std::string& how = command.arguments[0];
  const auto send = [&](QEvent::Type type) {
    QKeyEvent event(type, sequence[0], Qt::NoModifier);
    QApplication::sendEvent(window_.scene().widget(), &event);
  };
  if (how != "press" && how != "release" && how != "tap") return wrong(command, "say press, release or tap");
  if (how != "release") send(QEvent::KeyPress);
  if (how == "tap") window_.bridge().advance(1);
  if (how != "press") send(QEvent::KeyRelease);
  return Done{};
}

Outcome ScriptRunner::steps(const ScriptCommand& command) {
  const auto count = toNumber(command.arguments[0]);
  if (!count || *count < 0) return wrong(command, "'" + command.arguments[0] + "' is not a number of steps");
  if (window_.bridge().clock() != SessionClock::Lockstep) {
    return wrong(command, "on screen time goes on by itself", "Use wait, or run with --offscreen.");
  }
  window_.devices().advance(static_cast<std::uint64_t>(*count));
  window_.bridge().advance(static_cast<std::uint64_t>(*count));
  return Done{};
}

bool ScriptRunner::isIn(const std::string& state) const {
  const SnapshotPtr snapshot = window_.bridge().snapshot();
  if (!snapshot) return state == "empty";
  if (state == "ended") {
    return snapshot->state == SessionState::Solved || snapshot->state == SessionState::Failed ||
           snapshot->state == SessionState::Stopped;
  }
  const auto wanted = states().find(state);
  return wanted != states().end() && wanted->second == snapshot->state;
}

Outcome ScriptRunner::wait(const ScriptCommand& command) {
  const std::string& state = command.arguments[0];
  const auto limit = toNumber(command.arguments[1]);
  if (!limit) return wrong(command, "'" + command.arguments[1] + "' is not a limit");
  if (window_.bridge().clock() == SessionClock::Lockstep) {
    for (auto left = static_cast<std::uint64_t>(*limit); left > 0 && !isIn(state);) {
      const std::uint64_t slice = std::min(kSlice, left);
      window_.bridge().advance(slice);
      left -= slice;
    }
  } else {
    QElapsedTimer timer;
    timer.start();
    while (!isIn(state) && static_cast<double>(timer.elapsed()) < *limit * 1000.0) {
      QApplication::processEvents(QEventLoop::AllEvents, 10);
      QThread::msleep(2);
    }
  }
  return isIn(state) ? Outcome(Done{}) : failed(command, "the session did not come to be " + state);
}

Outcome ScriptRunner::expect(const ScriptCommand& command) {
  if (isIn(command.arguments[0])) return Done{};
  return failed(command, "the session is not " + command.arguments[0]);
}

}  // namespace glissade
