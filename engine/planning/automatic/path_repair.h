#pragma once

#include <memory>
#include <vector>

#include "engine/planning/automatic/rrt_connect.h"
#include "engine/planning/fine/sub_planner.h"

namespace glissade {

/// What shrinking and repairing count their work in: yes/no and distance queries, and motion checks as several.
std::uint64_t queriesOf(const PlannerCounts& counts);

/// Makes a way of a smaller object one of this problem's object: configurations are retracted from
/// what they would now collide with, straight motions between them are certified, and where one is
/// not, a local search bridges the gap, taking in more of the way each time it fails. Gives up when
/// its work is spent.
///
/// It has no roadmap while it works; once solved, its nodes are those of the path.
class PathRepair final : public Planner {
 public:
  struct Options {
    CollisionWorldPtr smaller;    ///< the world that the way is from
    double grownBy = 0.0;         ///< between that object and this, metres; <= 0: it shrank
    RrtConnect::Options search;   ///< of the gaps
    std::uint64_t work = 20'000;  ///< queries
  };

  PathRepair(const Problem& problem, std::uint64_t seed, std::vector<Pose> way, Options options);

  bool solve(PlannerHost& host) override;

  const std::vector<RoadmapNode>& nodes() const override { return nodes_; }
  const std::vector<RoadmapEdge>& edges() const override { return edges_; }
  const std::vector<std::uint32_t>& droppedEdges() const override { return dropped_; }
  const PlannerCounts& counts() const override { return counts_; }
  const Path* path() const override { return path_ ? &*path_ : nullptr; }
  std::optional<Diagnostic> failure() const override { return failure_; }

 private:
  void step(PlannerHost& host);
  void retractNext();
  std::optional<Pose> moveToClearance(const Pose& q);
  void linkNext(PlannerHost& host);
  void startGap();
  void searchGap(PlannerHost& host);
  void deliver(PlannerHost& host);
  void updateCounts();

  Problem problem_;
  Options options_;
  std::uint64_t seed_;
  RandomStream stream_;
  std::unique_ptr<CollisionQuery> query_;
  std::unique_ptr<CollisionQuery> smallerQuery_;
  std::vector<Pose> way_;      ///< still to be retracted, from `retracted_` on
  std::size_t retracted_ = 1;  ///< configurations before are free
  std::size_t linked_ = 0;     ///< motions up to this configuration are certified

  std::unique_ptr<SubPlanner> search_;  ///< of the gap between first_ and last_
  std::size_t first_ = 0;
  std::size_t last_ = 0;
  std::uint64_t gapWork_ = 0;   ///< queries that the search may still make
  std::uint64_t searches_ = 0;  ///< so far: each has a seed of its own
  SharedRoadmap gap_;

  PlannerCounts counts_;
  std::vector<RoadmapNode> nodes_;
  std::vector<RoadmapEdge> edges_;
  std::vector<std::uint32_t> dropped_;
  std::optional<Path> path_;
  std::optional<Diagnostic> failure_;
};

}  // namespace glissade
