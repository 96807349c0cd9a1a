#pragma once

#include <memory>

#include "engine/planning/automatic/eroded_worlds.h"
#include "engine/planning/automatic/portfolio_report.h"
#include "engine/planning/automatic/rrt_connect.h"
#include "engine/planning/fine/sub_planner.h"

namespace glissade {

/// Shrink and repair: a path is found first for the eroded object. It is then found again near itself while the object
/// grows back, a little beyond its size and back again (after D. Hsu, G. Sanchez-Ante, H. Cheng, J.-C. Latombe,
/// "Multi-level free-space dilation for sampling narrow passages in PRM planning", 2006; here for single queries).
/// If a level takes too long, the step of growth is halved. The planner gives up after several halvings: the way of
/// the smaller object may not exist for the whole object, and a new seed may find another way.
///
/// Nodes and edges are those of the level of the object itself, because those of the eroded levels are not free.
class ShrinkRepair final : public Planner, public ReportsStages {
 public:
  struct Options {
    double erosion = 0.0;  ///< depth of the first level, metres
    double growth = 0.0;   ///< growth beyond the object's size, metres
    RrtConnect::Options search;
    std::uint64_t firstWork = 30'000;   ///< limit of queries for the first level
    std::uint64_t repairWork = 60'000;  ///< limit of queries for each other level
    int halvings = 4;                   ///< limit of halvings of a level's growth, in all
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
  std::vector<double> depths_;  ///< one depth per level; the last is 0
  std::size_t level_ = 0;
  int halvings_ = 0;
  std::vector<Pose> way_;  ///< way of the level before
  double wayDepth_ = 0.0;  ///< depth of that level
  std::unique_ptr<SubPlanner> search_;
  SharedRoadmap eroded_;  ///< roadmap of the present level, unless that is the last
  SharedRoadmap own_;     ///< roadmap of the last level
  PlannerCounts counts_;
  std::uint64_t levelWork_ = 0;  ///< queries made before the level began
  std::optional<Path> path_;
  std::optional<Diagnostic> failure_;
};

}  // namespace glissade
