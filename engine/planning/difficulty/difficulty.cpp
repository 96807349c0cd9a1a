#include "engine/planning/difficulty/difficulty.h"

#include <algorithm>
#include <limits>

#include "engine/collision/motion_certificate.h"
#include "engine/planning/difficulty/tree_gaps.h"

namespace glissade {
namespace {

using Node = std::uint32_t;
constexpr Node kNone = std::numeric_limits<Node>::max();

/// The way from a node to the oldest node of its component, which is its root.
std::vector<Pose> wayToRoot(const GrownTrees& grown, Node from) {
  std::vector<Node> before(grown.nodes.size(), kNone);
  std::vector<Node> queue{from};
  before[from] = from;
  for (std::size_t head = 0; head < queue.size(); ++head) {
    for (const Node next : grown.links[queue[head]]) {
      if (before[next] != kNone) continue;
      before[next] = queue[head];
      queue.push_back(next);
    }
  }
  std::vector<Pose> way;
  for (Node node = *std::min_element(queue.begin(), queue.end()); node != from; node = before[node]) {
    way.push_back(grown.nodes[node].q);
  }
  way.push_back(grown.nodes[from].q);
  return way;
}

void takeTightest(const std::vector<Pose>& way, double required, CollisionQuery& query, const StopToken& stop,
                  std::optional<Difficulty::Passage>& tightest) {
  for (std::size_t i = 0; i + 1 < way.size() && !stop.stopRequested(); ++i) {
    const MotionCertificate edge = certifyMotion(query, way[i], way[i + 1], required, stop);
    if (edge.nearest.body < 0 || (tightest && edge.minClearance >= tightest->clearance)) continue;
    tightest = {edge.minClearance, edge.nearest.body, interpolate(way[i], way[i + 1], edge.at)};
  }
}

}  // namespace

Difficulty difficultyOf(const Problem& problem, const std::vector<RoadmapNode>& nodes,
                        const std::vector<RoadmapEdge>& edges, const ParameterValues& parameters, std::uint64_t seed,
                        const PenetrationBudget& budget, const WorkWatch& watch) {
  const StopToken& stop = watch.stop;
  Difficulty result;
  const auto query = problem.world->makeQuery();
  const double required = parameters[ParameterId::RequiredClearance];
  const GrownTrees grown = grownTrees(problem, nodes, edges, *query);
  const std::vector<TreeGap> gaps = treeGaps(grown, problem.metric(), 0.0, 1, stop);
  if (!gaps.empty()) {
    const TreeGap& gap = gaps.front();
    Difficulty::Frontier frontier{grown.nodes[gap.start].q, grown.nodes[gap.goal].q, gap.distance, -1, {}};
    const MotionCertificate between = certifyMotion(*query, frontier.fromStart, frontier.fromGoal, required, stop);
    if (between.status == CertificateStatus::Violated) {
      frontier.body = between.nearest.body;
      frontier.blockedAt = interpolate(frontier.fromStart, frontier.fromGoal, between.at);
    }
    result.frontier = frontier;
    takeTightest(wayToRoot(grown, gap.start), required, *query, stop, result.tightest);
    takeTightest(wayToRoot(grown, gap.goal), required, *query, stop, result.tightest);
  }
  result.leastPenetration = leastPenetration(problem, parameters, seed, budget, watch);
  return result;
}

}  // namespace glissade
