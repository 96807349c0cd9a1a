#pragma once

#include <map>

#include "engine/environment/semantic_model.h"
#include "engine/planning/coarse/coarse_plan.h"
#include "engine/planning/coarse/strategy_rules.h"

namespace glissade {

/// What the semantic planner adds to the costs of equation (1) as it learns from failed steps.
struct LearntCosts {
  std::map<std::pair<int, int>, double> crossing;  ///< place and border to reach: metres to add
};

/// The topological graph for a query, its costs set by the rules (paper 2, equation (1)).
/// `size` in rules is the largest extent of the workspace. Places marked forbidden cost infinitely
/// much, `preference` divides the costs of a place's edges, whatever the rules say. A cost that is negative
/// or divided by zero is a MalformedInput error naming the rule and the place.
Result<TopologicalGraph> makeTopologicalGraph(const TopologicalMap& map, const SemanticModel& semantics,
                                              const ParsedRules& rules, const Vector3& start, const Vector3& goal,
                                              const LearntCosts& learnt);

/// The cheapest path from S to G (Dijkstra 1959), as node indices; empty where none is of finite cost.
std::vector<int> cheapestPath(const TopologicalGraph& graph);

/// Edge of the graph between two nodes. Precondition: there is one.
const TopologicalGraph::Edge& edgeBetween(const TopologicalGraph& graph, int from, int to);

/// The coarse planning of a query: the graph, its cheapest path, split into steps (a place to cross
/// and a border to reach each), milestones not drawn yet. Without a way `nodes` and `steps` are empty.
/// Errors are those of makeTopologicalGraph(). Whoever knows the basis adds it.
Result<CoarsePlan> makeCoarsePlan(const TopologicalMap& map, const SemanticModel& semantics, const ParsedRules& rules,
                                  const Vector3& start, const Vector3& goal, const LearntCosts& learnt);

/// The same places and borders under the same numbers; neither may be null.
bool samePlaces(const EnvironmentModelPtr& a, const EnvironmentModelPtr& b);

/// Names of rules about one place: "distance", "size", "place.*", "object.*".
NameLookup placeLookup(const SemanticModel& semantics, std::size_t place, double distance, double size);

}  // namespace glissade
