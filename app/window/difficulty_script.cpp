#include "app/window/difficulty_script.h"

#include "app/window/difficulty_controller.h"

namespace glissade {
namespace {

/// The body that a part names; nothing where the part is not there.
std::optional<int> bodyOf(const Difficulty& difficulty, const std::string& part) {
  if (part == "least" && difficulty.leastPenetration) return difficulty.leastPenetration->body;
  if (part == "tightest" && difficulty.tightest) return difficulty.tightest->body;
  if (part == "frontier" && difficulty.frontier) return difficulty.frontier->body;
  return std::nullopt;
}

Outcome expect(const LoadedScenario& scenario, const DifficultyPtr& difficulty, const std::string& part,
               const std::string& body) {
  const auto found = difficulty ? bodyOf(*difficulty, part) : std::nullopt;
  const std::string name = !found || *found < 0 ? "-" : scenario.obstacles[static_cast<std::size_t>(*found)].id;
  if (name == body) return Done{};
  return unmetExpectation("'" + part + "' names " + name + ", not " + body);
}

}  // namespace

void addDifficultyCommands(const Workbench& bench, DifficultyController& difficulty) {
  using Words = ScriptCommands::Words;
  bench.scripts.add("show-difficulty", 1, [&difficulty](const Words& words) -> Outcome {
    if (difficulty.panel()->showPart(QString::fromStdString(words[0]))) return Done{};
    return wrongCommand("nothing is known of '" + words[0] + "'");
  });
  bench.scripts.add("expect-difficulty", 2, [&bench, &difficulty](const Words& words) -> Outcome {
    if (!bench.document.scenario()) return wrongCommand("no scenario is open");
    return expect(*bench.document.scenario(), difficulty.difficulty(), words[0], words[1]);
  });
}

}  // namespace glissade
