#include "engine/planning/difficulty/difficulty.h"

#include <algorithm>
#include <limits>

#include "engine/collision/motion_certificate.h"
#include "engine/planning/goal_roots.h"
#include "engine/planning/nearest_neighbours.h"

namespace glissade {
namespace {

using Node = std::uint32_t;
constexpr Node kNone = std::numeric_limits<Node>::max();

struct NodePair {
  Node start = kNone;
  Node goal = kNone;
  double distance = std::numeric_limits<double>::infinity();
};

/// What was grown, with the goal's roots where no planner grew a tree from them.
struct Grown {
  std::vector<RoadmapNode> nodes;
  std::vector<std::vector<Node>> links;
};

Grown grownFrom(const Problem& problem, const std::vector<RoadmapNode>& nodes, const std::vector<RoadmapEdge>& edges,
                CollisionQuery& query) {
  Grown grown{nodes, {}};
  const auto has = [&](TreeSide side) {
    return std::any_of(nodes.begin(), nodes.end(), [&](const RoadmapNode& node) { return node.side == side; });
  };
  if (!has(TreeSide::Start)) grown.nodes.push_back({problem.start, Author::Computer, TreeSide::Start});
  if (!has(TreeSide::Goal)) {
    for (const Pose& q : goalRoots(problem, query)) grown.nodes.push_back({q, Author::Computer, TreeSide::Goal});
  }
  grown.links.resize(grown.nodes.size());
  for (const auto& [a, b] : edges) {
    grown.links[a].push_back(b);
    grown.links[b].push_back(a);
  }
  return grown;
}

NodePair nearestPair(const Grown& grown, const Se3Metric& metric, const StopToken& stop) {
  NearestNeighbours goals(metric);
  for (Node node = 0; node < grown.nodes.size(); ++node) {
    if (grown.nodes[node].side == TreeSide::Goal) goals.add(node, grown.nodes[node].q);
  }
  NodePair best;
  for (Node node = 0; node < grown.nodes.size() && !stop.stopRequested(); ++node) {
    if (grown.nodes[node].side != TreeSide::Start) continue;
    const auto near = goals.nearest(grown.nodes[node].q);
    if (near && near->distance < best.distance) best = {node, near->index, near->distance};
  }
  return best;
}

/// The way from a node to the oldest one of its component: the root that it grew from.
std::vector<Pose> wayToRoot(const Grown& grown, Node from) {
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
  const Grown grown = grownFrom(problem, nodes, edges, *query);
  const NodePair pair = nearestPair(grown, problem.metric(), stop);
  if (pair.start != kNone) {
    Difficulty::Frontier frontier{grown.nodes[pair.start].q, grown.nodes[pair.goal].q, pair.distance, -1, {}};
    const MotionCertificate between = certifyMotion(*query, frontier.fromStart, frontier.fromGoal, required, stop);
    if (between.status == CertificateStatus::Violated) {
      frontier.body = between.nearest.body;
      frontier.blockedAt = interpolate(frontier.fromStart, frontier.fromGoal, between.at);
    }
    result.frontier = frontier;
    takeTightest(wayToRoot(grown, pair.start), required, *query, stop, result.tightest);
    takeTightest(wayToRoot(grown, pair.goal), required, *query, stop, result.tightest);
  }
  result.leastPenetration = leastPenetration(problem, parameters, seed, budget, watch);
  return result;
}

}  // namespace glissade
