#pragma once

#include "engine/base/message.h"
#include "engine/planning/planner.h"

namespace glissade {

/// Base of the deterministic local planners. Such a planner has no roadmap: it tries one path and gives up if the path
/// is blocked.
class DirectPlanner : public Planner {
 public:
  bool solve(PlannerHost& host) final;

  const std::vector<RoadmapNode>& nodes() const final { return nodes_; }
  const std::vector<RoadmapEdge>& edges() const final { return edges_; }
  const std::vector<std::uint32_t>& droppedEdges() const final { return dropped_; }
  const PlannerCounts& counts() const final { return counts_; }
  const Path* path() const final { return path_ ? &*path_ : nullptr; }
  std::optional<Diagnostic> failure() const final { return failure_; }

 protected:
  explicit DirectPlanner(const Problem& problem);

  /// The next configuration on the way; nothing: the way ends. `done` is set at the goal.
  virtual std::optional<Pose> next(const Pose& q, bool& done, PlannerHost& host) = 0;

  const Problem& problem() const { return problem_; }
  CollisionQuery& query() { return *query_; }
  /// The goal; for "out" the first configuration outside. Nothing where there is none.
  const std::optional<Pose>& goal() const { return goal_; }

 private:
  void giveUp(const Message& reason);

  Problem problem_;
  std::unique_ptr<CollisionQuery> query_;
  std::optional<Pose> goal_;
  std::vector<RoadmapNode> nodes_;
  std::vector<RoadmapEdge> edges_;
  std::vector<std::uint32_t> dropped_;
  PlannerCounts counts_;
  std::optional<Path> path_;
  std::optional<Diagnostic> failure_;
};

/// Linear interpolation from start to goal (paper 2, section 4.2: "the least complex cases").
class LinearPlanner final : public DirectPlanner {
 public:
  explicit LinearPlanner(const Problem& problem) : DirectPlanner(problem) {}

 private:
  std::optional<Pose> next(const Pose& q, bool& done, PlannerHost& host) override;
};

/// Potential field (O. Khatib, "Real-time obstacle avoidance", 1985): down the slope of attraction to
/// the goal and repulsion from the nearest obstacle, with a short tangential slide where both balance.
/// Gives up in a local minimum.
class PotentialFieldPlanner final : public DirectPlanner {
 public:
  explicit PotentialFieldPlanner(const Problem& problem) : DirectPlanner(problem) {}

 private:
  std::optional<Pose> next(const Pose& q, bool& done, PlannerHost& host) override;

  double bestDistance_ = 1e300;  ///< smallest distance to the goal so far, in the metric
  int stepsWithoutGain_ = 0;
};

}  // namespace glissade
