#include "app/window/assembly_script.h"

#include <sstream>

#include "app/window/assembly_controller.h"
#include "app/window/environment_controller.h"
#include "engine/base/number_text.h"

namespace glissade {
namespace {

constexpr double kMillimetres = 1000.0;
constexpr double kDegrees = 180.0 / 3.14159265358979323846;
/// As fine as the placement panel shows it.
constexpr double kSame = 0.01;

AssemblyItem itemOf(const std::string& what) {
  if (what == "start") return {AssemblyItem::Kind::Start, {}};
  if (what == "goal") return {AssemblyItem::Kind::Goal, {}};
  return {AssemblyItem::Kind::Body, what};
}

/// "1,2.5,-3"
Result<Vector3> numbersOf(const std::string& text) {
  std::istringstream words(text);
  Vector3 numbers = Vector3::Zero();
  std::string word;
  int count = 0;
  for (; std::getline(words, word, ','); ++count) {
    const auto number = toNumber(word);
    if (!number || count == 3) break;
    numbers[count] = *number;
  }
  if (count == 3 && words.eof()) return numbers;
  return Diagnostic{ErrorKind::MalformedInput, "", "", "'" + text + "' is not three numbers",
                    "Give them with commas and no blanks."};
}

}  // namespace

std::optional<Outcome> AssemblyScript::carryOut(const ScriptCommand& command) {
  const auto& words = command.arguments;
  if (command.name == "new-scenario") {
    return takePart(PartsDialog::Purpose::NewScenario, PartRole::Moves, words);
  }
  if (command.name == "add-part") {
    const PartRole role = words[1] == "mobile" ? PartRole::Mobile : PartRole::Static;
    return takePart(PartsDialog::Purpose::AddParts, role, {words[0], words[2], words[3]});
  }
  if (command.name == "rule") return setRule(words[0], words[1]);
  if (command.name == "place") return place(words[0], words[1], words[2]);
  if (command.name == "expect-place") return expectPlace(words[0], words[1]);
  return std::nullopt;
}

/// `words`: file, unit, up.
Outcome AssemblyScript::takePart(PartsDialog::Purpose purpose, PartRole role, const std::vector<std::string>& words) {
  const auto unit = toNumber(words[1]);
  if (!unit) return Diagnostic{ErrorKind::MalformedInput, "", "", "'" + words[1] + "' is no unit", "Give metres."};
  Outcome outcome = Done{};
  const auto refused =
      QObject::connect(&window_.parts(), &PartImport::failed, [&outcome](const Diagnostic& why) { outcome = why; });
  PartFile part = usualPart(words[0]);
  part.role = role;
  part.unit = *unit;
  part.up = words[2] == "Y" ? UpAxis::Y : UpAxis::Z;
  window_.parts().take(purpose, {part});
  QObject::disconnect(refused);
  return outcome;
}

Outcome AssemblyScript::setRule(const std::string& which, const std::string& expression) {
  Scenario after = window_.assembly().document().current();
  StrategyRules rules = after.rules.value_or(presetRules("gts"));
  (which == "node" ? rules.node : rules.edge) = expression;
  const auto& table = window_.environment().document().table();
  const auto parsed = parseRules(rules, table, idsOf(makeLocalPlannerRegistry()));
  if (!parsed) return parsed.error();
  after.rules = std::move(rules);
  return window_.assembly().document().edit(QStringLiteral("rule"), std::move(after));
}

Outcome AssemblyScript::place(const std::string& what, const std::string& position, const std::string& turn) {
  const auto millimetres = numbersOf(position);
  if (!millimetres) return millimetres.error();
  const auto degrees = numbersOf(turn);
  if (!degrees) return degrees.error();
  const Vector3 angles = *degrees / kDegrees;
  const Pose X_WB{*millimetres / kMillimetres, fromRollPitchYaw(angles.x(), angles.y(), angles.z())};
  return window_.assembly().document().place(itemOf(what), X_WB);
}

Outcome AssemblyScript::expectPlace(const std::string& what, const std::string& position) {
  const Diagnostic elsewhere{ErrorKind::NoPath, "", "", "'" + what + "' is not at " + position, ""};
  const auto pose = poseOf(window_.assembly().document().scenario()->scenario, itemOf(what));
  if (position == "nowhere" || !pose) {
    const bool met = position == "nowhere" && !pose;
    return met ? Outcome(Done{}) : elsewhere;
  }
  const auto millimetres = numbersOf(position);
  if (!millimetres) return millimetres.error();
  const double off = (kMillimetres * pose->position - *millimetres).cwiseAbs().maxCoeff();
  return off <= kSame ? Outcome(Done{}) : elsewhere;
}

}  // namespace glissade
