#include "engine/planning/fine/semantic_planner.h"

#include "engine/planning/fine/geometrical_planner.h"

namespace glissade {
namespace {

Message planners(const FineChoice& choice) {
  if (!choice.geometrical) return Message(choice.local);
  return {GLISSADE_TEXT("geometrical planner, then %1"), {choice.local}};
}

}  // namespace

FineChoice chooseFor(const TopologicalStep& step, const SceneKnowledge& knowledge, const SemanticModel& semantics,
                     const ParsedRules& rules) {
  const auto& crossing = knowledge.fits[static_cast<std::size_t>(step.place)].crossing;
  const auto isEnd = [&](const Pose& q) { return q == crossing->before || q == crossing->behind; };
  if (rules.fitted && crossing && isEnd(step.from) && isEnd(step.to)) {
    return {false, "linear", GLISSADE_TEXT("a straight crossing fits, so linear")};
  }
  const double distance = (step.to.position - step.from.position).norm();
  return chooseFinePlanners(knowledge.environment->map, semantics, rules, step.place, distance);
}

FineChoice chooseFinePlanners(const TopologicalMap& map, const SemanticModel& semantics, const ParsedRules& rules,
                              int place, double distance) {
  const auto p = static_cast<std::size_t>(place);
  const NameLookup lookup = placeLookup(semantics, p, distance, map.grid.frame.side);
  FineChoice choice;
  for (const ParsedRules::Fine& rule : rules.fine) {
    if (!rule.when.holds(lookup)) continue;
    choice.geometrical = rule.geometrical;
    choice.local = rule.local;
    break;
  }
  const std::string complexity = toText(semantics.ofPlace(p, "complexity").value);
  const bool cluttered = std::get<bool>(semantics.ofPlace(p, "cluttered").value);
  choice.why = {cluttered ? GLISSADE_TEXT("complexity %1, cluttered, so %2") : GLISSADE_TEXT("complexity %1, so %2"),
                {complexity, planners(choice)}};
  return choice;
}

FineChoice fallbackFor(const ParsedRules& rules, const FineChoice& blocked) {
  FineChoice choice{rules.fine.front().geometrical, rules.fine.front().local, blocked.why};
  choice.why = {GLISSADE_TEXT("%1; blocked, so %2"), {choice.why, planners(choice)}};
  return choice;
}

SamplingRegionPtr areaOf(const SceneKnowledge& knowledge, int place, int fromBorder, int toBorder, bool geometrical,
                         const Pose& from, const Pose& to, double objectRadius, const StopToken& stop) {
  const TopologicalMap& map = knowledge.environment->map;
  std::vector<std::size_t> area = map.places[static_cast<std::size_t>(place)].cells;
  for (const int border : {fromBorder, toBorder}) {
    if (border >= 0) area = unionOf(area, map.borders[static_cast<std::size_t>(border)].cells);
  }
  if (geometrical) {
    const auto path = findCellPath(*knowledge.environment, area, knowledge.environment->clearance, from.position,
                                   to.position, objectRadius, stop);
    if (!path.empty()) area = regionAlong(map.grid, path, area, 1.5 * objectRadius);
  }
  return std::make_shared<const SamplingRegion>(map.grid, std::move(area));
}

}  // namespace glissade
