#pragma once

#include "engine/planning/planner.h"

namespace glissade {

/// A roadmap and counts that several planners grow together, each appending what is new.
struct SharedRoadmap {
  std::vector<RoadmapNode> nodes;
  std::vector<RoadmapEdge> edges;
  std::vector<std::uint32_t> droppedEdges;
  PlannerCounts counts;
};

/// A planner that works on a part of a problem, one step at a time, for another planner.
class SubPlanner {
 public:
  /// `samples` limits its random configurations. The operator takes part while the object in his hand
  /// is in the region (null: everywhere).
  SubPlanner(std::unique_ptr<Planner> planner, std::uint64_t samples, SamplingRegionPtr region)
      : planner_(std::move(planner)), samples_(samples), region_(std::move(region)) {}

  enum class State { Running, Solved, Failed };
  /// One step; what it grew and cost is added to the roadmap.
  State step(PlannerHost& host, SharedRoadmap& roadmap);
  /// One step alone: to be followed, some time, by collect().
  State advance(PlannerHost& host);
  /// Adds what was grown and spent since the last time.
  void collect(SharedRoadmap& roadmap);
  /// Adds what the planner has grown but not listed yet (Planner::completeRoadmap).
  void complete(SharedRoadmap& roadmap);

  const Planner& planner() const { return *planner_; }
  std::uint64_t randomConfigurations() const { return planner_->counts().randomConfigurations; }
  /// What collect() has added so far.
  const PlannerCounts& collected() const { return counted_; }

 private:
  std::unique_ptr<Planner> planner_;
  std::uint64_t samples_;
  SamplingRegionPtr region_;
  std::vector<std::uint32_t> nodeIn_;  ///< index in the shared roadmap, per own node
  std::vector<std::uint32_t> edgeIn_;
  std::size_t droppedTaken_ = 0;
  PlannerCounts counted_;
};

}  // namespace glissade
