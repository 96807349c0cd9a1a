#include "app/window/replay_script.h"

#include "app/window/replay_controller.h"
#include "engine/base/number_text.h"

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

}  // namespace

void addReplayCommands(ScriptCommands& scripts, ReplayController& replay) {
  using Words = ScriptCommands::Words;
  scripts.add("save-recording", 1,
              [&replay](const Words& words) { return outcomeOf(replay.save(QString::fromStdString(words[0]))); });
  scripts.add("seek", 1, [&replay](const Words& words) { return seek(replay, words[0]); });
  scripts.add("expect-replay", 1, [&replay](const Words& words) { return expectReplay(replay, words[0]); });
}

}  // namespace glissade
