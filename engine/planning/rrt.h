#pragma once

#include <memory>

#include "engine/planning/planner.h"
#include "engine/planning/random_shooter.h"
#include "engine/planning/roadmap_graph.h"

namespace glissade {

/// One tree from the start (S. M. LaValle, "Rapidly-exploring random trees", 1998), as strategy G of
/// paper 2 (section 6.1) uses it and as its local planner. Deviations: an extension goes straight as
/// far as it is free instead of one fixed step, and ends off the obstacle, as our BiRRT's; one draw
/// in twenty is the goal (LaValle and Kuffner 2001); the delivered path is certified.
class Rrt final : public Planner {
 public:
  /// Strategy G gives up at the parameter `global_samples`; a local planner goes on for ever.
  enum class Limit { None, GlobalSamples };

  Rrt(const Problem& problem, std::uint64_t seed, Limit limit = Limit::None);

  bool solve(PlannerHost& host) override;

  const std::vector<RoadmapNode>& nodes() const override { return roadmap_.nodes(); }
  const std::vector<RoadmapEdge>& edges() const override { return roadmap_.edges(); }
  const std::vector<std::uint32_t>& droppedEdges() const override { return roadmap_.droppedEdges(); }
  const PlannerCounts& counts() const override { return counts_; }
  const Path* path() const override { return path_ ? &*path_ : nullptr; }
  std::optional<Diagnostic> failure() const override { return failure_; }

 private:
  void iterate(PlannerHost& host);
  /// The node that the tree grew by, and whether it is q itself.
  struct Extension {
    RoadmapGraph::Node node;
    bool reached;
  };
  std::optional<Extension> extend(const Pose& q, PlannerHost& host);
  void deliverPath(RoadmapGraph::Node goal, PlannerHost& host);

  Problem problem_;
  Limit limit_;
  std::unique_ptr<CollisionQuery> query_;
  RandomStream goalStream_;
  RandomShooter randomShooter_;
  RoadmapGraph roadmap_;
  RoadmapGraph::Node startRoot_ = 0;
  std::vector<Pose> goals_;
  PlannerCounts counts_;
  std::optional<Path> path_;
  std::optional<Diagnostic> failure_;
};

}  // namespace glissade
