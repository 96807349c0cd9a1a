#pragma once

#include <functional>

#include "engine/planning/planner.h"
#include "engine/planning/screw_ways.h"

namespace glissade {

/// Turns the object out of the threads in which it is engaged at the start, and into those at the goal, by screw
/// motions of both senses; another planner plans the rest, where the rule of the threads does not hold. The path is
/// certified as one. Where no screw motion is free there is no path.
class ThreadedPlanner final : public Planner {
 public:
  using Make = std::function<std::unique_ptr<Planner>(const Problem&)>;
  /// `make` makes the planner of the rest, `ways` finds the screw motions.
  ThreadedPlanner(Problem problem, Make make, std::unique_ptr<const ScrewWays> ways);

  bool solve(PlannerHost& host) override;

  const std::vector<RoadmapNode>& nodes() const override { return nodes_; }
  const std::vector<RoadmapEdge>& edges() const override { return edges_; }
  const std::vector<std::uint32_t>& droppedEdges() const override { return dropped_; }
  const PlannerCounts& counts() const override { return counts_; }
  const Path* path() const override { return path_ ? &*path_ : nullptr; }
  void completeRoadmap() override;
  std::optional<Diagnostic> failure() const override;
  const Planner* inner() const override { return rest_.get(); }

 private:
  class Host;
  bool prepare(PlannerHost& host);
  bool findWays(const Pose& end, PlannerHost& host, std::vector<Pose>& way);
  void addChain(const std::vector<Pose>& poses, TreeSide side);
  void takeGrown();
  bool deliver(PlannerHost& host, const std::vector<PathPoint>& middle);

  Problem problem_;
  Make make_;
  std::unique_ptr<const ScrewWays> ways_;
  std::unique_ptr<CollisionQuery> query_;
  bool prepared_ = false;
  std::vector<Pose> out_;  ///< from the start to the beginning of the rest; empty: the rest begins at the start
  std::vector<Pose> in_;   ///< from the goal to the end of the rest; empty: the rest ends at the goal
  std::unique_ptr<Planner> rest_;
  std::vector<RoadmapNode> nodes_;
  std::vector<RoadmapEdge> edges_;
  std::vector<std::uint32_t> dropped_;
  std::size_t ownNodes_ = 0;
  std::size_t ownEdges_ = 0;
  PlannerCounts counts_;
  std::optional<Path> path_;
  std::optional<Diagnostic> failure_;
};

}  // namespace glissade
