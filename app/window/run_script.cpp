#include "app/window/run_script.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QThread>

#include <algorithm>

#include "engine/base/number_text.h"
#include "engine/operator/device_registry.h"

namespace glissade {
namespace {

/// Planner steps between two looks at the state while waiting offscreen.
constexpr std::uint64_t kWaitSlice = 50;

const std::map<std::string, SessionState>& states() {
  static const std::map<std::string, SessionState> byName{
      {"idle", SessionState::Idle},     {"planning", SessionState::Planning}, {"paused", SessionState::Paused},
      {"solved", SessionState::Solved}, {"stopped", SessionState::Stopped},   {"failed", SessionState::Failed}};
  return byName;
}

bool isIn(const SnapshotPtr& snapshot, const std::string& state) {
  if (!snapshot) return state == "empty";
  if (state == "ended") {
    return snapshot->state == SessionState::Solved || snapshot->state == SessionState::Failed ||
           snapshot->state == SessionState::Stopped;
  }
  const auto expected = states().find(state);
  return expected != states().end() && expected->second == snapshot->state;
}

struct NamedValue {
  ParameterId id;
  double value;
};

/// `words`: a parameter's key and a value.
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
  if (makePlannerRegistry().find(id) == nullptr) return wrongCommand("there is no strategy '" + id + "'");
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

}  // namespace

void addRunCommands(const Workbench& bench) {
  using Words = ScriptCommands::Words;
  ScriptCommands& scripts = bench.scripts;
  SessionBridge& session = bench.session;
  scripts.add("set", 2, [&session](const Words& words) { return setParameter(session, words); });
  scripts.add("expect-value", 2, [&session](const Words& words) { return expectValue(session, words); });
  scripts.add("select-operator", 1, [&session](const Words& words) { return selectOperator(session, words[0]); });
  scripts.add("select-strategy", 1, [&session](const Words& words) { return selectStrategy(session, words[0]); });
  scripts.add("wait", 2, [&session](const Words& words) { return wait(session, words[0], words[1]); });
  scripts.add("expect", 1, [&session](const Words& words) -> Outcome {
    if (isIn(session.snapshot(), words[0])) return Done{};
    return unmetExpectation("the session is not in the state '" + words[0] + "'");
  });
}

}  // namespace glissade
