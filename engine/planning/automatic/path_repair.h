#pragma once

#include <memory>
#include <vector>

#include "engine/planning/automatic/rrt_connect.h"
#include "engine/planning/fine/sub_planner.h"

namespace glissade {

/// The work of shrinking and repairing: yes/no queries, distance queries, and motion checks, each of which counts as
/// several queries.
std::uint64_t queriesOf(const PlannerCounts& counts);

/// Repairs the way of a smaller object for this problem's object. Configurations that would now collide are retracted,
/// and the straight motions between them are certified. Where a motion fails, a local search bridges the gap and
/// replaces a longer part of the way each time it fails. The planner gives up when its work is spent.
///
/// It has no roadmap while it works. After success its nodes are those of the path.
class PathRepair final : public Planner {
 public:
  struct Options {
    CollisionWorldPtr smaller;    ///< world in which the way is free
    double grownBy = 0.0;         ///< growth from that object to this one, metres; <= 0: it shrank
    RrtConnect::Options search;   ///< options of the searches that bridge gaps
    std::uint64_t work = 20'000;  ///< limit of queries
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
  std::vector<Pose> way_;      ///< configurations from `retracted_` on are still to be retracted
  std::size_t retracted_ = 1;  ///< configurations before this index are free
  std::size_t linked_ = 0;     ///< motions up to this configuration are certified

  std::unique_ptr<SubPlanner> search_;  ///< search for the gap between first_ and last_
  std::size_t first_ = 0;
  std::size_t last_ = 0;
  std::uint64_t gapWork_ = 0;   ///< queries that the search may still make
  std::uint64_t searches_ = 0;  ///< number of searches so far: each has a seed of its own
  SharedRoadmap gap_;

  PlannerCounts counts_;
  std::vector<RoadmapNode> nodes_;
  std::vector<RoadmapEdge> edges_;
  std::vector<std::uint32_t> dropped_;
  std::optional<Path> path_;
  std::optional<Diagnostic> failure_;
};

}  // namespace glissade
