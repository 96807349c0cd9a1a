#include "engine/planning/tree_planner.h"

#include <algorithm>
#include <cmath>

#include "engine/planning/goal_roots.h"
#include "engine/planning/path_certificate.h"

namespace glissade {

TreePlanner::TreePlanner(const Problem& problem, const Se3Metric& metric)
    : problem_(problem), query_(problem.world->makeQuery()), metric_(metric), roadmap_(metric) {
  startRoot_ = roadmap_.addRoot({problem_.start, Author::Computer, TreeSide::Start});
}

TreePlanner::Extension TreePlanner::extension(Node from, const Pose& q, double distance, const ExtensionRule& rule,
                                              PlannerHost& host) {
  const Pose& origin = roadmap_.nodes()[from].q;
  const double length = std::min(distance, rule.range);
  const Pose target = length < distance ? interpolate(origin, q, length / distance) : q;
  const double free = freeFraction(*query_, origin, target, rule.sampling, host.stopToken());
  if (free >= 1.0) return {length < distance ? Progress::Advanced : Progress::Reached, target};
  const double t = std::floor(free * length / rule.grid) * rule.grid / length;
  if (t * length < rule.least) return {Progress::Trapped, origin};
  return {Progress::Blocked, interpolate(origin, target, t)};
}

std::vector<PathPoint> TreePlanner::pointsOf(const RoadmapGraph::Way& way) const {
  std::vector<PathPoint> points;
  Node before = way.nodes.front();
  for (const Node node : way.nodes) {
    const Author segment = roadmap_.nodes()[std::max(before, node)].author;
    points.push_back({roadmap_.nodes()[node].q, roadmap_.nodes()[node].author, segment});
    before = node;
  }
  return points;
}

TreePlanner::Delivery TreePlanner::deliverWay(Node goal, PlannerHost& host) {
  const auto way = roadmap_.way(startRoot_, goal);
  if (!way) return Delivery::NoWay;
  Path path;
  path.points = pointsOf(*way);
  path.certificate = certifyPath(*query_, path.points, host.parameters(), host.stopToken());
  if (path.certificate.status == CertificateStatus::Certified) {
    path_ = std::move(path);
    return Delivery::Delivered;
  }
  if (host.stopToken().stopRequested()) return Delivery::Stopped;
  roadmap_.dropEdge(way->edges[path.certificate.edge]);
  return Delivery::Dropped;
}

void TreePlanner::addGoalRoots() {
  for (const Pose& q : goalRoots(problem_, *query_)) {
    goalRoots_.push_back(roadmap_.addRoot({q, Author::Computer, TreeSide::Goal}));
  }
}

void TreePlanner::updateCounts() {
  counts_.nodes = roadmap_.nodes().size();
  counts_.edges = roadmap_.directedEdgeCount();
  counts_.droppedEdges = roadmap_.droppedEdges().size();
  counts_.queries = query_->counts();
}

}  // namespace glissade
