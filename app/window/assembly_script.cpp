#include "app/window/assembly_script.h"

#include <sstream>

#include "app/window/part_import.h"
#include "engine/base/number_text.h"

namespace glissade {
namespace {

constexpr double kMillimetres = 1000.0;
constexpr double kDegrees = 180.0 / 3.14159265358979323846;
/// As fine as the placement panel shows it.
constexpr double kSame = 0.01;

using Words = ScriptCommands::Words;

Diagnostic noScenario() { return wrongCommand("no scenario is open", "Open one first."); }

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
  return wrongCommand("'" + text + "' is not three numbers", "Give them with commas and no blanks.");
}

/// `words`: file, unit, up.
Outcome takePart(PartImport& parts, PartsDialog::Purpose purpose, PartRole role, const Words& words) {
  const auto unit = toNumber(words[1]);
  if (!unit) return wrongCommand("'" + words[1] + "' is not a unit", "Give metres.");
  Outcome outcome = Done{};
  const auto refused =
      QObject::connect(&parts, &PartImport::importFailed, [&outcome](const Diagnostic& why) { outcome = why; });
  PartFile part = usualPart(words[0]);
  part.role = role;
  part.unit = *unit;
  part.up = words[2] == "Y" ? UpAxis::Y : UpAxis::Z;
  parts.take(purpose, {part});
  QObject::disconnect(refused);
  return outcome;
}

Outcome setRule(WorkbenchDocument& document, const std::string& which, const std::string& expression) {
  if (!document.scenario()) return noScenario();
  StrategyRules rules = document.scenario()->scenario.rules.value_or(presetRules("gts"));
  (which == "node" ? rules.node : rules.edge) = expression;
  const auto& table = document.semantics().table();
  const auto parsed = parseRules(rules, table, idsOf(makeLocalPlannerRegistry()));
  if (!parsed) return parsed.error();
  return document.edit(QStringLiteral("rule"), [rules](Scenario& scenario) {
    scenario.rules = rules;
    return Outcome(Done{});
  });
}

Outcome place(WorkbenchDocument& document, const std::string& what, const std::string& position,
              const std::string& turn) {
  if (!document.scenario()) return noScenario();
  const auto millimetres = numbersOf(position);
  if (!millimetres) return millimetres.error();
  const auto degrees = numbersOf(turn);
  if (!degrees) return degrees.error();
  const Vector3 angles = *degrees / kDegrees;
  const Pose X_WB{*millimetres / kMillimetres, fromRollPitchYaw(angles.x(), angles.y(), angles.z())};
  return document.place(itemOf(what), X_WB);
}

Outcome expectPlace(WorkbenchDocument& document, const std::string& what, const std::string& position) {
  if (!document.scenario()) return noScenario();
  const Diagnostic elsewhere = unmetExpectation("'" + what + "' is not at " + position);
  const auto pose = poseOf(document.scenario()->scenario, itemOf(what));
  if (position == "nowhere" || !pose) {
    const bool met = position == "nowhere" && !pose;
    return met ? Outcome(Done{}) : elsewhere;
  }
  const auto millimetres = numbersOf(position);
  if (!millimetres) return millimetres.error();
  const double off = (kMillimetres * pose->position - *millimetres).cwiseAbs().maxCoeff();
  return off <= kSame ? Outcome(Done{}) : elsewhere;
}

}  // namespace

void addAssemblyCommands(const Workbench& bench, PartImport& parts) {
  ScriptCommands& scripts = bench.scripts;
  WorkbenchDocument& document = bench.document;
  scripts.add("new-scenario", 3, [&parts](const Words& words) {
    return takePart(parts, PartsDialog::Purpose::NewScenario, PartRole::Moves, words);
  });
  scripts.add("add-part", 4, [&parts, &document](const Words& words) -> Outcome {
    if (!document.scenario()) return noScenario();
    const PartRole role = words[1] == "mobile" ? PartRole::Mobile : PartRole::Static;
    return takePart(parts, PartsDialog::Purpose::AddParts, role, {words[0], words[2], words[3]});
  });
  scripts.add("rule", 2, [&document](const Words& words) { return setRule(document, words[0], words[1]); });
  scripts.add("place", 3, [&document](const Words& words) { return place(document, words[0], words[1], words[2]); });
  scripts.add("expect-place", 2, [&document](const Words& words) { return expectPlace(document, words[0], words[1]); });
}

}  // namespace glissade
