#include "engine/planning/difficulty/tree_gaps.h"

#include <algorithm>

#include "engine/planning/goal_roots.h"
#include "engine/planning/nearest_neighbours.h"

namespace glissade {
namespace {

using Node = std::uint32_t;

/// The gap at each node of the start's tree.
std::vector<TreeGap> allGaps(const GrownTrees& trees, const Se3Metric& metric, const StopToken& stop) {
  NearestNeighbours goals(metric);
  for (Node node = 0; node < trees.nodes.size(); ++node) {
    if (trees.nodes[node].side == TreeSide::Goal) goals.add(node, trees.nodes[node].q);
  }
  std::vector<TreeGap> gaps;
  for (Node node = 0; node < trees.nodes.size() && !stop.stopRequested(); ++node) {
    if (trees.nodes[node].side != TreeSide::Start) continue;
    const auto near = goals.nearest(trees.nodes[node].q);
    if (near) gaps.push_back({node, near->index, near->distance});
  }
  return gaps;
}

}  // namespace

GrownTrees grownTrees(const Problem& problem, const std::vector<RoadmapNode>& nodes,
                      const std::vector<RoadmapEdge>& edges, CollisionQuery& query) {
  GrownTrees trees{nodes, {}};
  const auto has = [&](TreeSide side) {
    return std::any_of(nodes.begin(), nodes.end(), [&](const RoadmapNode& node) { return node.side == side; });
  };
  if (!has(TreeSide::Start)) trees.nodes.push_back({problem.start, Author::Computer, TreeSide::Start});
  if (!has(TreeSide::Goal)) {
    for (const Pose& q : goalRoots(problem, query)) trees.nodes.push_back({q, Author::Computer, TreeSide::Goal});
  }
  trees.links.resize(trees.nodes.size());
  for (const auto& [a, b] : edges) {
    trees.links[a].push_back(b);
    trees.links[b].push_back(a);
  }
  return trees;
}

std::vector<TreeGap> treeGaps(const GrownTrees& trees, const Se3Metric& metric, double apart, std::size_t most,
                              const StopToken& stop) {
  std::vector<TreeGap> gaps = allGaps(trees, metric, stop);
  std::stable_sort(gaps.begin(), gaps.end(),
                   [](const TreeGap& a, const TreeGap& b) { return a.distance < b.distance; });
  std::vector<TreeGap> chosen;
  for (const TreeGap& gap : gaps) {
    if (chosen.size() == most) break;
    const bool another = std::all_of(chosen.begin(), chosen.end(), [&](const TreeGap& before) {
      return metric.distance(trees.nodes[gap.start].q, trees.nodes[before.start].q) >= apart;
    });
    if (another) chosen.push_back(gap);
  }
  return chosen;
}

}  // namespace glissade
