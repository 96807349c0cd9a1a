#pragma once

#include "engine/planning/planner.h"

namespace glissade {

/// Tries the motions that a person tries first: the straight motion to the goal; straight out along an axis or along
/// the normal of a contact face; the same while turning about that direction, as a screw; and for a goal that is a
/// configuration: lift along such a direction, cross, set down. Every motion is certified. Each step tries one motion;
/// the planner gives up after the last.
class DirectMotions final : public Planner {
 public:
  explicit DirectMotions(const Problem& problem);

  bool solve(PlannerHost& host) override;

  const std::vector<RoadmapNode>& nodes() const override { return nodes_; }
  const std::vector<RoadmapEdge>& edges() const override { return edges_; }
  const std::vector<std::uint32_t>& droppedEdges() const override { return dropped_; }
  const PlannerCounts& counts() const override { return counts_; }
  const Path* path() const override { return path_ ? &*path_ : nullptr; }
  std::optional<Diagnostic> failure() const override { return failure_; }

 private:
  void addMotionsOut(const std::vector<Vector3>& directions);
  void addMotionsAcross(const Pose& goal, const std::vector<Vector3>& directions);
  void add(std::vector<Pose> motion);
  void tryNext(PlannerHost& host);

  Problem problem_;
  std::unique_ptr<CollisionQuery> query_;
  /// Motions in the order in which they are tried: configurations from start to goal.
  std::vector<std::vector<Pose>> candidates_;
  std::size_t next_ = 0;
  std::vector<RoadmapNode> nodes_;
  std::vector<RoadmapEdge> edges_;
  std::vector<std::uint32_t> dropped_;
  PlannerCounts counts_;
  std::optional<Path> path_;
  std::optional<Diagnostic> failure_;
};

}  // namespace glissade
