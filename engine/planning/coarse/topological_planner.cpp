#include "engine/planning/coarse/topological_planner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace glissade {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

RuleValue toRuleValue(const AttributeValue& value) {
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? 1.0 : 0.0;
  if (const double* number = std::get_if<double>(&value)) return *number;
  return std::get<std::string>(value);
}

/// Splits "prefix.attribute"; the prefix is empty where there is no dot.
std::pair<std::string, std::string> split(const std::string& name) {
  const std::size_t dot = name.find('.');
  if (dot == std::string::npos) return {"", name};
  return {name.substr(0, dot), name.substr(dot + 1)};
}

bool flagOf(const SemanticModel& semantics, std::size_t place, const char* attribute) {
  return std::get<bool>(semantics.ofPlace(place, attribute).value);
}

double numberOf(const SemanticModel& semantics, std::size_t place, const char* attribute) {
  return std::get<double>(semantics.ofPlace(place, attribute).value);
}

/// Largest rounding error of a cost that is 0.
constexpr double kRounding = 1e-9;

/// The cost that a rule gives. A negative cost is an error, because Dijkstra's algorithm needs costs of at least 0.
Result<double> costBy(const Expression& rule, const char* pointer, const NameLookup& lookup, const Message& where) {
  const double value = rule.number(lookup);
  if (value >= -kRounding) return std::max(0.0, value);
  const Message reason = std::isnan(value) ? Message(GLISSADE_TEXT("divides by zero %1"), {where})
                                           : Message(GLISSADE_TEXT("gives the negative cost %1 %2"), {value, where});
  return Diagnostic{ErrorKind::MalformedInput,
                    "",
                    pointer,
                    reason,
                    {GLISSADE_TEXT("A cost is 0 or more: correct the rule %1"), {rule.text()}}};
}

}  // namespace

NameLookup placeLookup(const SemanticModel& semantics, std::size_t place, double distance, double size) {
  return [&semantics, place, distance, size](const std::string& name) -> RuleValue {
    const auto [prefix, attribute] = split(name);
    if (prefix.empty()) return attribute == "size" ? size : distance;
    return toRuleValue(prefix == "object" ? semantics.ofObject(attribute).value
                                          : semantics.ofPlace(place, attribute).value);
  };
}

Result<TopologicalGraph> makeTopologicalGraph(const TopologicalMap& map, const SemanticModel& semantics,
                                              const ParsedRules& rules, const Vector3& start, const Vector3& goal,
                                              const LearntCosts& learnt) {
  const double size = map.grid.frame.side;
  TopologicalGraph graph;
  graph.nodes.push_back({-1, start, 0.0});
  graph.nodes.push_back({-1, goal, 0.0});
  std::vector<std::vector<int>> nodesOf(map.places.size());
  const auto attach = [&](int place, int node) {
    if (place != kNoPlace) nodesOf[static_cast<std::size_t>(place)].push_back(node);
  };
  attach(map.placeNear(start), TopologicalGraph::kStart);
  attach(map.placeNear(goal), TopologicalGraph::kGoal);
  for (std::size_t b = 0; b < map.borders.size(); ++b) {
    const Border& border = map.borders[b];
    const NameLookup lookup = [&](const std::string& name) -> RuleValue {
      const auto [prefix, attribute] = split(name);
      if (prefix.empty()) return size;
      if (prefix == "object") return toRuleValue(semantics.ofObject(attribute).value);
      const int place = prefix == "a" ? border.placeA : border.placeB;
      return toRuleValue(semantics.ofPlace(static_cast<std::size_t>(place), attribute).value);
    };
    const auto nameOf = [&](int place) { return semantics.placeName(static_cast<std::size_t>(place)); };
    const auto cost = costBy(rules.node, "/rules/node", lookup,
                             {GLISSADE_TEXT("between %1 and %2"), {nameOf(border.placeA), nameOf(border.placeB)}});
    if (!cost) return cost.error();
    const int node = static_cast<int>(graph.nodes.size());
    graph.nodes.push_back({static_cast<int>(b), border.centre, *cost});
    attach(border.placeA, node);
    attach(border.placeB, node);
  }
  for (std::size_t place = 0; place < nodesOf.size(); ++place) {
    const bool forbidden = flagOf(semantics, place, "forbidden");
    const double preference = numberOf(semantics, place, "preference");
    for (const int from : nodesOf[place]) {
      for (const int to : nodesOf[place]) {
        if (to == from) continue;
        const double distance =
            (graph.nodes[static_cast<std::size_t>(from)].p_W - graph.nodes[static_cast<std::size_t>(to)].p_W).norm();
        const auto cost = costBy(rules.edge, "/rules/edge", placeLookup(semantics, place, distance, size),
                                 {GLISSADE_TEXT("in place %1"), {semantics.placeName(place)}});
        if (!cost) return cost.error();
        double edgeCost = *cost / preference;
        const auto raised =
            learnt.crossing.find({static_cast<int>(place), graph.nodes[static_cast<std::size_t>(to)].border});
        if (raised != learnt.crossing.end()) edgeCost += raised->second;
        graph.edges.push_back({from, to, static_cast<int>(place), distance, forbidden ? kInfinite : edgeCost});
      }
    }
  }
  return graph;
}

std::vector<int> cheapestPath(const TopologicalGraph& graph) {
  std::vector<double> reached(graph.nodes.size(), kInfinite);
  std::vector<int> before(graph.nodes.size(), -1);
  std::vector<std::vector<const TopologicalGraph::Edge*>> leaving(graph.nodes.size());
  for (const auto& edge : graph.edges) leaving[static_cast<std::size_t>(edge.from)].push_back(&edge);
  std::set<std::pair<double, int>> open{{0.0, TopologicalGraph::kStart}};
  reached[TopologicalGraph::kStart] = 0.0;
  while (!open.empty()) {
    const auto [spent, node] = *open.begin();
    open.erase(open.begin());
    if (node == TopologicalGraph::kGoal) break;
    for (const auto* edge : leaving[static_cast<std::size_t>(node)]) {
      const auto to = static_cast<std::size_t>(edge->to);
      const double total = spent + edge->cost + graph.nodes[to].cost;
      if (total >= reached[to]) continue;
      open.erase({reached[to], edge->to});
      reached[to] = total;
      before[to] = node;
      open.insert({total, edge->to});
    }
  }
  std::vector<int> path;
  if (reached[TopologicalGraph::kGoal] == kInfinite) return path;
  for (int node = TopologicalGraph::kGoal; node >= 0; node = before[static_cast<std::size_t>(node)]) {
    path.push_back(node);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

const TopologicalGraph::Edge& edgeBetween(const TopologicalGraph& graph, int from, int to) {
  const TopologicalGraph::Edge* best = nullptr;
  for (const auto& edge : graph.edges) {
    if (edge.from == from && edge.to == to && (best == nullptr || edge.cost < best->cost)) best = &edge;
  }
  return *best;
}

namespace {

/// The name of a border, for example "B1-6" between P1 and P6, independent of the user's names; a letter distinguishes
/// several borders of the same places.
std::string borderName(const TopologicalMap& map, const SemanticModel& semantics, int border) {
  const Border& b = map.borders[static_cast<std::size_t>(border)];
  const auto shortName = [&](int place) {
    const std::string& name = semantics.placeName(static_cast<std::size_t>(place));
    const bool number = name.size() > 1 && name.front() == 'P' && name.find_first_not_of("0123456789", 1) == name.npos;
    return number ? name.substr(1) : name;
  };
  const char last = b.name.back();
  const std::string letter = last >= 'a' && last <= 'z' ? std::string(1, last) : std::string();
  return "B" + shortName(b.placeA) + "-" + shortName(b.placeB) + letter;
}

/// Adds the places and borders of infinite cost to a plan without a way.
void nameWhatIsClosed(CoarsePlan& plan, const TopologicalMap& map, const SemanticModel& semantics) {
  std::set<int> closed;
  for (const TopologicalGraph::Edge& edge : plan.graph->edges) {
    if (edge.cost == kInfinite) closed.insert(edge.place);
  }
  for (const int place : closed) {
    const auto p = static_cast<std::size_t>(place);
    (flagOf(semantics, p, "forbidden") ? plan.forbidden : plan.infiniteCost).push_back(semantics.placeName(p));
  }
  for (const TopologicalGraph::Node& node : plan.graph->nodes) {
    if (node.cost == kInfinite) plan.infiniteCost.push_back(borderName(map, semantics, node.border));
  }
}

}  // namespace

Result<CoarsePlan> makeCoarsePlan(const TopologicalMap& map, const SemanticModel& semantics, const ParsedRules& rules,
                                  const Vector3& start, const Vector3& goal, const LearntCosts& learnt) {
  CoarsePlan plan;
  auto made = makeTopologicalGraph(map, semantics, rules, start, goal, learnt);
  if (!made) return made.error();
  const auto graph = std::make_shared<const TopologicalGraph>(std::move(*made));
  plan.graph = graph;
  plan.nodes = cheapestPath(*graph);
  for (std::size_t i = 1; i < plan.nodes.size(); ++i) {
    const TopologicalGraph::Edge& edge = edgeBetween(*graph, plan.nodes[i - 1], plan.nodes[i]);
    const TopologicalGraph::Node& node = graph->nodes[static_cast<std::size_t>(plan.nodes[i])];
    plan.cost += edge.cost + node.cost;
    TopologicalStep step;
    step.place = edge.place;
    step.border = node.border;
    step.placeName = semantics.placeName(static_cast<std::size_t>(edge.place));
    step.borderName = node.border < 0 ? "G" : borderName(map, semantics, node.border);
    plan.steps.push_back(std::move(step));
  }
  if (plan.nodes.empty()) nameWhatIsClosed(plan, map, semantics);
  return plan;
}

bool samePlaces(const EnvironmentModelPtr& a, const EnvironmentModelPtr& b) {
  if (a == b) return true;
  const CellGrid& here = a->map.grid;
  const CellGrid& there = b->map.grid;
  return here.level == there.level && here.counts == there.counts && here.frame.side == there.frame.side &&
         here.frame.origin == there.frame.origin && a->map.placeOf == b->map.placeOf &&
         a->map.borders.size() == b->map.borders.size();
}

}  // namespace glissade
