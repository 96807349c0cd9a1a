#include "app/window/difficulty_script.h"

#include "app/window/difficulty_controller.h"

namespace glissade {
namespace {

Diagnostic usage(const std::string& reason) { return {ErrorKind::MalformedInput, "", "", reason, "Correct the line."}; }

/// The body that a part names; nothing where the part is not there.
std::optional<int> bodyOf(const Difficulty& difficulty, const std::string& part) {
  if (part == "least" && difficulty.leastPenetration) return difficulty.leastPenetration->body;
  if (part == "tightest" && difficulty.tightest) return difficulty.tightest->body;
  if (part == "frontier" && difficulty.frontier) return difficulty.frontier->body;
  return std::nullopt;
}

}  // namespace

std::optional<Outcome> DifficultyScript::carryOut(const ScriptCommand& command) {
  if (command.name == "show-difficulty") return show(command.arguments[0]);
  if (command.name == "expect-difficulty") return expect(command.arguments[0], command.arguments[1]);
  return std::nullopt;
}

Outcome DifficultyScript::show(const std::string& part) {
  if (window_.difficulty().panel()->showPart(QString::fromStdString(part))) return Done{};
  return usage("nothing is known of '" + part + "'");
}

Outcome DifficultyScript::expect(const std::string& part, const std::string& body) {
  const DifficultyController& controller = window_.difficulty();
  const auto found = controller.difficulty() ? bodyOf(*controller.difficulty(), part) : std::nullopt;
  const std::string name =
      !found || *found < 0 ? "-" : controller.scenario()->obstacles[static_cast<std::size_t>(*found)].id;
  if (name == body) return Done{};
  return Diagnostic{ErrorKind::NoPath, "", "", "'" + part + "' names " + name + ", not " + body, ""};
}

}  // namespace glissade
