#include "app/window/replay_script.h"

#include "app/window/replay_controller.h"
#include "engine/base/number_text.h"

namespace glissade {
namespace {

Outcome toOutcome(const std::optional<Diagnostic>& why) { return why ? Outcome(*why) : Outcome(Done{}); }

Diagnostic usage(const std::string& reason) { return {ErrorKind::MalformedInput, "", "", reason, "Correct the line."}; }

Diagnostic unmet(const std::string& reason) { return {ErrorKind::NoPath, "", "", reason, ""}; }

}  // namespace

std::optional<Outcome> ReplayScript::carryOut(const ScriptCommand& command) {
  if (command.name == "save-recording") {
    return toOutcome(window_.replay().save(QString::fromStdString(command.arguments[0])));
  }
  if (command.name == "replay") {
    const SnapshotPtr live = window_.bridge().snapshot();
    if (live && isRunning(*live)) return usage("a run is under way");
    const std::string& file = command.arguments[0];
    return toOutcome(window_.openRecording(readRunRecord(file), QString::fromStdString(file), true));
  }
  if (command.name == "seek") return seek(command.arguments[0]);
  if (command.name == "expect-replay") return expectReplay(command.arguments[0]);
  return std::nullopt;
}

Outcome ReplayScript::seek(const std::string& step) {
  const auto wanted = toNumber(step);
  if (!wanted || *wanted < 0) return usage("'" + step + "' is not a step");
  if (!window_.replay().isActive()) return usage("no replay is open");
  window_.replay().seek(static_cast<std::uint64_t>(*wanted));
  return Done{};
}

Outcome ReplayScript::expectReplay(const std::string& verdict) {
  const ReplayController& replay = window_.replay();
  const std::string found = replay.isActive() ? replay.verdict() : "closed";
  if (found == verdict) return Done{};
  return unmet("the replay is " + (found.empty() ? "still running" : found) + ", not " + verdict);
}

}  // namespace glissade
