#pragma once

#include <map>

#include "engine/places/semantic_model.h"
#include "engine/planning/coarse/coarse_plan.h"
#include "engine/planning/coarse/strategy_rules.h"

namespace glissade {

/// Costs that the semantic planner adds to those of equation (1) after failed steps.
struct LearntCosts {
  std::map<std::pair<int, int>, double> crossing;  ///< metres to add, by place and border to reach
};

/// The topological graph for a query, its costs set by the rules (paper 2, equation (1)). `size` in rules is the
/// largest extent of the workspace. Independently of the rules, forbidden places cost infinitely much, and `preference`
/// divides the costs of a place's edges. A cost that is negative or divided by zero is a MalformedInput error naming
/// the rule and the place.
Result<TopologicalGraph> makeTopologicalGraph(const TopologicalMap& map, const SemanticModel& semantics,
                                              const ParsedRules& rules, const Vector3& start, const Vector3& goal,
                                              const LearntCosts& learnt);

/// The cheapest path from S to G (Dijkstra 1959), as node indices; empty where no path has a finite cost.
std::vector<int> cheapestPath(const TopologicalGraph& graph);

/// The edge of the graph between two nodes. Precondition: it exists.
const TopologicalGraph::Edge& edgeBetween(const TopologicalGraph& graph, int from, int to);

/// The coarse planning of a query: the graph, its cheapest path, split into steps (a place to cross and a border to
/// reach each), without milestones. Without a way `nodes` and `steps` are empty. Errors are those of
/// makeTopologicalGraph(). The caller adds the basis.
Result<CoarsePlan> makeCoarsePlan(const TopologicalMap& map, const SemanticModel& semantics, const ParsedRules& rules,
                                  const Vector3& start, const Vector3& goal, const LearntCosts& learnt);

/// True if both models have the same places and borders under the same numbers. Precondition: neither is null.
bool samePlaces(const EnvironmentModelPtr& a, const EnvironmentModelPtr& b);

/// Values of the names in rules about one place: "distance", "size", "place.*", "object.*".
NameLookup placeLookup(const SemanticModel& semantics, std::size_t place, double distance, double size);

}  // namespace glissade
