#pragma once

#include <memory>

#include "engine/planning/automatic/eroded_worlds.h"
#include "engine/planning/automatic/portfolio_report.h"
#include "engine/planning/automatic/rrt_connect.h"
#include "engine/planning/fine/sub_planner.h"

namespace glissade {

/// Shrink and repair: a path of the eroded object is found first, then found again near itself while
/// the object grows back, a little beyond its size and back again (after D. Hsu, G. Sanchez-Ante,
/// H. Cheng, J.-C. Latombe, "Multi-level free-space dilation for sampling narrow passages in PRM
/// planning", 2006; here for single queries). Where a level takes too long the object grows by half as
/// much first; gives up after some of these: the way of the smaller object may be none of the whole.
/// Then a fresh seed may find another.
///
/// Nodes and edges are those of the level of the object itself; the eroded ones' are not free.
class ShrinkRepair final : public Planner, public ReportsStages {
 public:
  struct Options {
    double erosion = 0.0;  ///< of the first level, metres
    double growth = 0.0;   ///< beyond the object's size, metres
    RrtConnect::Options search;
    std::uint64_t firstWork = 30'000;   ///< queries for the first level
    std::uint64_t repairWork = 60'000;  ///< queries for each of the others
    int halvings = 4;                   ///< of a level's growth, all in all
  };

  ShrinkRepair(const Problem& problem, std::uint64_t seed, const Options& options,
               std::shared_ptr<ErodedWorlds> worlds);

  bool solve(PlannerHost& host) override;

  const std::vector<RoadmapNode>& nodes() const override { return own_.nodes; }
  const std::vector<RoadmapEdge>& edges() const override { return own_.edges; }
  const std::vector<std::uint32_t>& droppedEdges() const override { return own_.droppedEdges; }
  const PlannerCounts& counts() const override { return counts_; }
  const Path* path() const override { return path_ ? &*path_ : nullptr; }
  std::optional<Diagnostic> failure() const override { return failure_; }
  std::size_t stagesDone() const override { return level_; }

 private:
  bool isLast() const { return level_ + 1 == depths_.size(); }
  void step(PlannerHost& host);
  void startLevel();
  void endLevel();
  void endAtGoal();
  void halveGrowth();

  Problem problem_;
  std::uint64_t seed_;
  Options options_;
  std::shared_ptr<ErodedWorlds> worlds_;
  std::vector<double> depths_;  ///< per level; the last is 0
  std::size_t level_ = 0;
  int halvings_ = 0;
  std::vector<Pose> way_;  ///< of the level before
  double wayDepth_ = 0.0;  ///< of that level
  std::unique_ptr<SubPlanner> search_;
  SharedRoadmap eroded_;  ///< of the present level, while that is not the last
  SharedRoadmap own_;     ///< of the last level
  PlannerCounts counts_;
  std::uint64_t levelWork_ = 0;  ///< queries when the level began
  std::optional<Path> path_;
  std::optional<Diagnostic> failure_;
};

}  // namespace glissade
