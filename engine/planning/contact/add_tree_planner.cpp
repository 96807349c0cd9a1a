#include "engine/planning/contact/add_tree_planner.h"

#include <algorithm>

#include "engine/base/tolerances.h"

namespace glissade {

AddTreePlanner::AddTreePlanner(const Problem& problem) : TreePlanner(problem, problem.metric()) {
  addGoalRoots();
  updateCounts();
}

void AddTreePlanner::passStep(Author author) {
  ++counts_.steps;
  lastAuthor_ = author;
}

double AddTreePlanner::longestEdge(std::size_t first) const {
  double longest = 0.0;
  for (std::size_t i = first; i < roadmap_.edges().size(); ++i) {
    const RoadmapEdge& edge = roadmap_.edges()[i];
    longest = std::max(longest, metric_.distance(roadmap_.nodes()[edge.from].q, roadmap_.nodes()[edge.to].q));
  }
  return longest;
}

/// Add_Tree(q): one step of the paper's BiRRT. Every component grows straight towards q up to the first obstacle; then
/// the new nodes are connected with each other.
void AddTreePlanner::addTree(const Pose& q, Author author, PlannerHost& host) {
  passStep(author);
  std::vector<Node> added;
  std::optional<Node> reached;
  for (const ComponentId component : roadmap_.components()) {
    if (const auto node = extend(component, q, author, reached, host)) added.push_back(*node);
    if (host.stopToken().stopRequested()) return;
  }
  connect(added, host);
}

/// Extends one component towards q. `reached` is the node at q itself once a component has reached it. A later
/// component that reaches q joins that node instead of adding q again.
std::optional<AddTreePlanner::Node> AddTreePlanner::extend(ComponentId component, const Pose& q, Author author,
                                                           std::optional<Node>& reached, PlannerHost& host) {
  const auto near = roadmap_.nearest(component, q);
  const double radius = problem_.world->objectRadius();
  const double same = author == Author::Computer ? tolerance::kSameConfiguration : tolerance::kDuplicate;
  if (near.distance < same * radius) return near.index;  // so near to q that it is worth connecting
  const double grid = author == Author::Computer ? host.parameters()[ParameterId::ExtensionStep]
                                                 : tolerance::kGuidedExtensionStep * radius;
  const ExtensionRule rule{host.parameters()[ParameterId::GrowthStep], grid, 0.5 * grid};
  const Extension grown = extension(near.index, q, near.distance, rule, host);
  const bool whole = grown.progress == Progress::Reached;
  if (whole && reached) {
    roadmap_.join(near.index, *reached);
    return std::nullopt;
  }
  if (grown.progress == Progress::Trapped || (!whole && isDuplicate(component, grown.end, author))) return std::nullopt;
  const Node node = roadmap_.addChild(near.index, {grown.end, author, roadmap_.nodes()[near.index].side});
  if (whole) reached = node;
  return node;
}

bool AddTreePlanner::isDuplicate(ComponentId component, const Pose& q, Author author) const {
  if (author == Author::Computer) return false;
  return roadmap_.nearest(component, q).distance < tolerance::kDuplicate * problem_.world->objectRadius();
}

void AddTreePlanner::connect(const std::vector<Node>& added, PlannerHost& host) {
  const double step = host.parameters()[ParameterId::GrowthStep];
  for (std::size_t i = 0; i < added.size(); ++i) {
    for (std::size_t j = i + 1; j < added.size(); ++j) {
      if (roadmap_.connected(added[i], added[j])) continue;
      const Pose& from = roadmap_.nodes()[added[i]].q;
      const Pose& to = roadmap_.nodes()[added[j]].q;
      if (freeFraction(*query_, from, to, step, host.stopToken()) >= 1.0) {
        roadmap_.join(added[i], added[j]);
      }
    }
  }
}

/// Drops an edge that cannot be certified, after which the search goes on.
void AddTreePlanner::deliverPath(PlannerHost& host) {
  for (const Node goal : goalRoots_) {
    const Delivery delivery = deliverWay(goal, host);
    if (delivery == Delivery::Delivered || delivery == Delivery::Stopped) return;
  }
}

}  // namespace glissade
