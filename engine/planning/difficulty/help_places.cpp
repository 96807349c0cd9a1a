#include "engine/planning/difficulty/help_places.h"

#include <algorithm>
#include <limits>

#include "engine/planning/difficulty/tree_gaps.h"

namespace glissade {
namespace {

/// Places begin so far apart, and a passage leads so far beyond its ends: in radii of the object.
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

/// The straight motion is free, or where it is not.
void lookStraight(const Problem& problem, double required, const StopToken& stop, HelpPlace& place) {
  const auto query = problem.world->makeQuery();
  const MotionCheck check = query->checkMotion(place.fromStart, place.fromGoal, required, SeekViolation::First, stop);
  if (check.status == CertificateStatus::Certified) place.lacking = 0.0;
  if (check.status != CertificateStatus::Violated) return;
  place.narrowest = interpolate(place.fromStart, place.fromGoal, check.at);
  place.body = query->nearestObstacle(place.narrowest).body;
}

}  // namespace

std::vector<HelpPlace> helpPlaces(const Problem& problem, const std::vector<RoadmapNode>& nodes,
                                  const std::vector<RoadmapEdge>& edges, const ParameterValues& parameters,
                                  std::uint64_t seed, std::size_t most, const PenetrationBudget& budget,
                                  const WorkWatch& watch) {
  const auto query = problem.world->makeQuery();
  const GrownTrees trees = grownTrees(problem, nodes, edges, *query);
  const Se3Metric metric = problem.metric();
  std::vector<HelpPlace> places;
  for (const TreeGap& gap : treeGaps(trees, metric, kApart * metric.radius(), most, watch.stop)) {
    if (watch.stop.stopRequested()) break;
    const auto done = static_cast<double>(places.size());
    const WorkWatch part = watch.part(done / static_cast<double>(most), (done + 1.0) / static_cast<double>(most));
    HelpPlace place{trees.nodes[gap.start].q, trees.nodes[gap.goal].q, gap.distance, {}, {}, -1, {}};
    place.narrowest = place.fromStart;
    place.passage = {place.fromStart, place.fromGoal};
    lookStraight(problem, parameters[ParameterId::RequiredClearance], watch.stop, place);
    if (!place.lacking) {
      const Problem local = between(problem, place.fromStart, place.fromGoal);
      if (auto least = leastPenetration(local, parameters, seed, budget, part)) {
        place.lacking = least->depth;
        place.passage = std::move(least->way);
        place.narrowest = least->q;
        place.body = least->body;
      }
    }
    places.push_back(std::move(place));
  }
  const auto lacking = [](const HelpPlace& place) {
    return place.lacking.value_or(std::numeric_limits<double>::infinity());
  };
  std::stable_sort(places.begin(), places.end(),
                   [&](const HelpPlace& a, const HelpPlace& b) { return lacking(a) < lacking(b); });
  return places;
}

}  // namespace glissade
