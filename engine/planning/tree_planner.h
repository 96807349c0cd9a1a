#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "engine/planning/planner.h"
#include "engine/planning/roadmap_graph.h"

namespace glissade {

/// Base of the planners that grow trees from the start and the goal: the roadmap, straight extensions, and the
/// certificate of the path that is delivered.
class TreePlanner : public Planner {
 public:
  const std::vector<RoadmapNode>& nodes() const final { return roadmap_.nodes(); }
  const std::vector<RoadmapEdge>& edges() const final { return roadmap_.edges(); }
  const std::vector<std::uint32_t>& droppedEdges() const final { return roadmap_.droppedEdges(); }
  const PlannerCounts& counts() const final { return counts_; }
  const Path* path() const final { return path_ ? &*path_ : nullptr; }

 protected:
  using Node = RoadmapGraph::Node;
  using ComponentId = RoadmapGraph::ComponentId;

  /// One tree, from the start. `metric` measures the length of extensions and finds the nearest nodes.
  TreePlanner(const Problem& problem, const Se3Metric& metric);

  /// Limits of an extension. Lengths are in the planner's metric (metres).
  struct ExtensionRule {
    double sampling = 0.0;  ///< distance between the configurations that are tested on the way
    double grid = 0.0;      ///< a blocked extension ends at a multiple of it, off the obstacle
    double least = 0.0;     ///< a shorter blocked extension is discarded
    double range = std::numeric_limits<double>::infinity();  ///< longest extension
  };
  enum class Progress { Reached, Advanced, Blocked, Trapped };
  struct Extension {
    /// Reached: q is reached; Advanced: the range ends before q; Blocked: an obstacle is before q; Trapped: nothing is
    /// free.
    Progress progress;
    Pose end;  ///< end of the extension, except for Trapped
  };
  /// The straight extension from a node towards q, at `distance` (> 0) from it. Adds nothing to the roadmap.
  Extension extension(Node from, const Pose& q, double distance, const ExtensionRule& rule, PlannerHost& host);

  /// The points of a way through the roadmap.
  std::vector<PathPoint> pointsOf(const RoadmapGraph::Way& way) const;

  enum class Delivery { NoWay, Delivered, Dropped, Stopped };
  /// Certifies the way from the start to this node, where there is one, and makes it the path. An edge that cannot be
  /// certified is dropped from the search.
  Delivery deliverWay(Node goal, PlannerHost& host);
  /// Adds one tree for each goal configuration.
  void addGoalRoots();
  void updateCounts();

  Problem problem_;
  std::unique_ptr<CollisionQuery> query_;
  Se3Metric metric_;
  RoadmapGraph roadmap_;
  Node startRoot_ = 0;
  std::vector<Node> goalRoots_;  ///< empty until addGoalRoots()
  PlannerCounts counts_;
  std::optional<Path> path_;
};

}  // namespace glissade
