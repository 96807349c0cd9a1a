#include "engine/sequence/step_cost.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace glissade {
namespace {

const std::string kOfBody = "body.";

struct NamedFigure {
  const char* name;
  double (*value)(const StepFigures& figures);
};

constexpr std::array<NamedFigure, 20> kFigures{{
    {"length", [](const StepFigures& figures) { return figures.length; }},
    {"turns", [](const StepFigures& figures) { return figures.turns; }},
    {"direction_change", [](const StepFigures& figures) { return figures.directionChange ? 1.0 : 0.0; }},
    {"turn_over", [](const StepFigures& figures) { return figures.turnOver; }},
    {"tool_change", [](const StepFigures& figures) { return figures.toolChange ? 1.0 : 0.0; }},
    {"falling", [](const StepFigures& figures) { return figures.falling; }},
    {"unsupported", [](const StepFigures& figures) { return figures.unsupported; }},
    {"bodies", [](const StepFigures& figures) { return figures.bodies; }},
    {"mass", [](const StepFigures& figures) { return figures.mass; }},
    {"fragile", [](const StepFigures& figures) { return figures.fragile ? 1.0 : 0.0; }},
    {"tool_blocked", [](const StepFigures& figures) { return figures.toolBlocked ? 1.0 : 0.0; }},
    {"task_change", [](const StepFigures& figures) { return figures.taskChange ? 1.0 : 0.0; }},
    {"assembly_change", [](const StepFigures& figures) { return figures.assemblyChange; }},
    {"distance", [](const StepFigures& figures) { return figures.distance; }},
    {"size", [](const StepFigures& figures) { return figures.size; }},
    {"early", [](const StepFigures& figures) { return figures.early; }},
    {"in_air", [](const StepFigures& figures) { return figures.inAir ? 1.0 : 0.0; }},
    {"open_stacks", [](const StepFigures& figures) { return figures.openStacks; }},
    {"unfastened", [](const StepFigures& figures) { return figures.unfastened; }},
    {"isolated_left", [](const StepFigures& figures) { return figures.isolatedLeft; }},
}};

const NamedFigure* figureNamed(const std::string& name) {
  const auto* found =
      std::find_if(kFigures.begin(), kFigures.end(), [&](const NamedFigure& each) { return name == each.name; });
  return found == kFigures.end() ? nullptr : found;
}

bool isOfBody(const std::string& name) { return name.rfind(kOfBody, 0) == 0; }

RuleType typeOf(const AttributeValue& value) {
  return std::holds_alternative<std::string>(value) ? RuleType::Text : RuleType::Number;
}

RuleValue ruleValue(const AttributeValue& value) {
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? 1.0 : 0.0;
  if (const double* number = std::get_if<double>(&value)) return *number;
  return std::get<std::string>(value);
}

/// The type of the attribute at the first body that has it.
std::optional<RuleType> typeOfAttribute(const std::string& name, const std::map<std::string, Attributes>& attributes) {
  for (const auto& [id, own] : attributes) {
    const auto known = own.find(name);
    if (known != own.end()) return typeOf(known->second);
  }
  return std::nullopt;
}

}  // namespace

std::vector<StepCostPreset> stepCostPresets() {
  return {{"fitter", GLISSADE_TEXT("As a fitter would"),
           "30 * in_air + 3 * isolated_left + 20 * tool_blocked + 15 * open_stacks + 10 * falling + unsupported"
           " + 2 * unfastened + 4 * task_change + 4 * assembly_change + 4 * turn_over + 2 * tool_change"
           " + direction_change + 2 * distance + 4 * size * early - 4 * fragile * early"},
          {"balanced", GLISSADE_TEXT("Balanced"), "length + direction_change + tool_change + 10 * falling"},
          {"steady", GLISSADE_TEXT("Steady"), "100 * falling + 0.1 * (length + direction_change + tool_change)"},
          {"few-tools", GLISSADE_TEXT("Few changes of tools"),
           "10 * tool_change + direction_change + length + 10 * falling"},
          {"short", GLISSADE_TEXT("Short motions"), "length + turns + 10 * falling"},
          {"fragile-first", GLISSADE_TEXT("Fragile parts removed first"),
           "if(fragile, 0, 5) + length + direction_change + tool_change"},
          {"as-found", GLISSADE_TEXT("As found"), "0"}};
}

Result<StepCost> StepCost::of(const SequenceDemands& demands) {
  const std::vector<StepCostPreset> presets = stepCostPresets();
  const auto preset =
      std::find_if(presets.begin(), presets.end(), [&](const auto& each) { return each.id == demands.cost; });
  const std::string text = preset != presets.end() ? preset->expression
                           : demands.cost.empty()  ? presets.front().expression
                                                   : demands.cost;
  const auto typeOfName = [&](const std::string& name) -> std::optional<RuleType> {
    if (figureNamed(name) != nullptr) return RuleType::Number;
    return isOfBody(name) ? typeOfAttribute(name.substr(kOfBody.size()), demands.attributes) : std::nullopt;
  };
  auto expression = Expression::parse(text, typeOfName);
  if (!expression) {
    Diagnostic why = expression.error();
    why.location = "/sequence/cost";
    return why;
  }
  return StepCost(std::move(*expression), demands.attributes);
}

double StepCost::of(const StepFigures& figures) const {
  const double cost = expression_.number([&](const std::string& name) -> RuleValue {
    if (const NamedFigure* figure = figureNamed(name)) return figure->value(figures);
    const std::string attribute = name.substr(kOfBody.size());
    const auto body = attributes_.find(figures.id.text());
    if (body != attributes_.end() && body->second.count(attribute) != 0) return ruleValue(body->second.at(attribute));
    const auto type = typeOfAttribute(attribute, attributes_);
    return type == RuleType::Text ? RuleValue(std::string()) : RuleValue(0.0);
  });
  return std::isnan(cost) ? 0.0 : std::max(0.0, cost);
}

}  // namespace glissade
