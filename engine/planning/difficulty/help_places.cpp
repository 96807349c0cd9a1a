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

/// The configuration of the tree of that side that is nearest to q. Precondition: the tree is not empty.
Pose nearestOf(const GrownTrees& trees, TreeSide side, const Pose& q, const Se3Metric& metric) {
  NearestNeighbours known(metric);
  for (std::uint32_t node = 0; node < trees.nodes.size(); ++node) {
    if (trees.nodes[node].side == side) known.add(node, trees.nodes[node].q);
  }
  return trees.nodes[known.nearest(q)->index].q;
}

/// The place with the configurations of the trees that are nearest to the deepest configuration of a way.
HelpPlace placeOnWay(const GrownTrees& trees, const Se3Metric& metric, const LeastPenetration& least) {
  HelpPlace place;
  place.fromStart = nearestOf(trees, TreeSide::Start, least.q, metric);
  place.fromGoal = nearestOf(trees, TreeSide::Goal, least.q, metric);
  place.distance = metric.distance(place.fromStart, place.fromGoal);
  place.narrowest = least.q;
  place.body = least.body;
  place.lacking = least.depth;
  const auto nearest = [&](const Pose& q) {
    return std::min_element(least.way.begin(), least.way.end(), [&](const Pose& a, const Pose& b) {
      return metric.distance(a, q) < metric.distance(b, q);
    });
  };
  const auto first = nearest(place.fromStart);
  const auto last = nearest(place.fromGoal);
  place.passage = {place.fromStart};
  if (first <= last) place.passage.insert(place.passage.end(), first, last + 1);
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
  if (wholeWay && !found.empty()) places.push_back(placeOnWay(trees, metric, *wholeWay));
  const auto better = [](const HelpPlace& a, const HelpPlace& b) { return leastOf(a) < leastOf(b); };
  std::stable_sort(places.begin(), places.end(), better);
  return places;
}

}  // namespace glissade
