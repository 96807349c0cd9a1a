#include "engine/planning/difficulty/help_places.h"

#include <algorithm>
#include <limits>

#include "engine/planning/difficulty/tree_gaps.h"
#include "engine/planning/nearest_neighbours.h"

namespace glissade {
namespace {

/// Least distance between the beginnings of places, and margin about the ends of a passage, in radii of the object.
constexpr double kApart = 1.0;
constexpr double kAround = 1.0;

/// The part of the problem between two configurations and their surroundings.
Problem between(const Problem& problem, const Pose& from, const Pose& to) {
  Problem part = problem;
  part.start = from;
  part.goal = to;
  part.region = nullptr;
  const Vector3 around = Vector3::Constant(kAround * problem.world->objectRadius());
  Box3 box(from.position);
  box.extend(to.position);
  part.bounds = Box3(box.min() - around, box.max() + around).intersection(problem.bounds);
  part.bounds.extend(from.position);
  part.bounds.extend(to.position);
  return part;
}

/// Checks the straight motion, and finds where it is blocked.
void lookStraight(const Problem& problem, double required, const StopToken& stop, HelpPlace& place) {
  const auto query = problem.world->makeQuery();
  const MotionCheck check = query->checkMotion(place.fromStart, place.fromGoal, required, SeekViolation::First, stop);
  if (check.status == CertificateStatus::Certified) place.lacking = 0.0;
  if (check.status != CertificateStatus::Violated) return;
  place.narrowest = interpolate(place.fromStart, place.fromGoal, check.at);
  place.body = query->nearestObstacle(place.narrowest).body;
}

HelpPlace placeAt(const Problem& problem, const GrownTrees& trees, const TreeGap& gap,
                  const ParameterValues& parameters, std::uint64_t seed, const PenetrationBudget& budget,
                  const WorkWatch& watch) {
  HelpPlace place;
  place.fromStart = place.narrowest = trees.nodes[gap.start].q;
  place.fromGoal = trees.nodes[gap.goal].q;
  place.distance = gap.distance;
  place.passage = {place.fromStart, place.fromGoal};
  lookStraight(problem, parameters[ParameterId::RequiredClearance], watch.stop, place);
  if (place.lacking) return place;
  const Problem local = between(problem, place.fromStart, place.fromGoal);
  auto least = leastPenetration(local, parameters, seed, budget, watch);
  if (!least) return place;
  place.lacking = least->depth;
  place.passage = std::move(least->way);
  place.narrowest = least->q;
  place.body = least->body;
  return place;
}

/// The configurations of the trees of one side.
NearestNeighbours treesOf(TreeSide side, const GrownTrees& trees, const Se3Metric& metric) {
  NearestNeighbours known(metric);
  for (std::uint32_t node = 0; node < trees.nodes.size(); ++node) {
    if (trees.nodes[node].side == side) known.add(node, trees.nodes[node].q);
  }
  return known;
}

/// The part of a whole way about its deepest configuration that leads from the start's trees to the goal's. It begins
/// at the last configuration before the deepest one from which the nearest one of the start's trees is reached by a
/// straight motion, and ends so at the goal's trees.
HelpPlace placeOnWay(const GrownTrees& trees, const Problem& problem, double required, const LeastPenetration& least) {
  const Se3Metric metric = problem.metric();
  const auto query = problem.world->makeQuery();
  const auto& way = least.way;
  const NearestNeighbours starts = treesOf(TreeSide::Start, trees, metric);
  const NearestNeighbours goals = treesOf(TreeSide::Goal, trees, metric);
  const auto nearestIn = [&](const NearestNeighbours& known, std::size_t i) -> const Pose& {
    return trees.nodes[known.nearest(way[i])->index].q;
  };
  const auto isReached = [&](const NearestNeighbours& known, std::size_t i) {
    return query->checkMotion(nearestIn(known, i), way[i], required, SeekViolation::Any, {}).status ==
           CertificateStatus::Certified;
  };
  const auto deepest = std::min_element(way.begin(), way.end(), [&](const Pose& a, const Pose& b) {
    return metric.distance(a, least.q) < metric.distance(b, least.q);
  });
  std::size_t first = static_cast<std::size_t>(deepest - way.begin());
  std::size_t last = first;
  while (first > 0 && !isReached(starts, first)) --first;
  while (last + 1 < way.size() && !isReached(goals, last)) ++last;
  HelpPlace place;
  place.fromStart = nearestIn(starts, first);
  place.fromGoal = nearestIn(goals, last);
  place.distance = metric.distance(place.fromStart, place.fromGoal);
  place.narrowest = least.q;
  place.body = least.body;
  place.lacking = least.depth;
  place.passage = {place.fromStart};
  place.passage.insert(place.passage.end(), way.begin() + static_cast<std::ptrdiff_t>(first),
                       way.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  place.passage.push_back(place.fromGoal);
  return place;
}

/// The missing clearance; infinite where no passage is known.
double leastOf(const HelpPlace& place) { return place.lacking.value_or(std::numeric_limits<double>::infinity()); }

}  // namespace

std::vector<HelpPlace> helpPlaces(const Problem& problem, const std::vector<RoadmapNode>& nodes,
                                  const std::vector<RoadmapEdge>& edges, const ParameterValues& parameters,
                                  std::uint64_t seed, const std::optional<LeastPenetration>& wholeWay, std::size_t gaps,
                                  const PenetrationBudget& budget, const WorkWatch& watch) {
  const auto query = problem.world->makeQuery();
  const GrownTrees trees = grownTrees(problem, nodes, edges, *query);
  const Se3Metric metric = problem.metric();
  const auto found = treeGaps(trees, metric, kApart * metric.radius(), gaps, watch.stop);
  std::vector<HelpPlace> places;
  for (std::size_t i = 0; i < found.size() && !watch.stop.stopRequested(); ++i) {
    const auto share = [&](std::size_t done) { return static_cast<double>(done) / static_cast<double>(found.size()); };
    const WorkWatch part = watch.part(share(i), share(i + 1));
    places.push_back(placeAt(problem, trees, found[i], parameters, seed, budget, part));
  }
  if (wholeWay && !found.empty()) {
    places.push_back(placeOnWay(trees, problem, parameters[ParameterId::RequiredClearance], *wholeWay));
  }
  const auto better = [](const HelpPlace& a, const HelpPlace& b) { return leastOf(a) < leastOf(b); };
  std::stable_sort(places.begin(), places.end(), better);
  return places;
}

}  // namespace glissade
