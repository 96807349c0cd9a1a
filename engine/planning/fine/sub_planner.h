#pragma once

#include "engine/planning/planner.h"

namespace glissade {

/// A roadmap and counts that several planners grow together, each appending its new nodes and edges.
struct SharedRoadmap {
  std::vector<RoadmapNode> nodes;
  std::vector<RoadmapEdge> edges;
  std::vector<std::uint32_t> droppedEdges;
  PlannerCounts counts;
};

/// A planner that works on a part of a problem, one step at a time, for another planner.
class SubPlanner {
 public:
  /// `samples` limits its random configurations. The operator takes part while the held object is in the region (null:
  /// everywhere).
  SubPlanner(std::unique_ptr<Planner> planner, std::uint64_t samples, SamplingRegionPtr region)
      : planner_(std::move(planner)), samples_(samples), region_(std::move(region)) {}

  enum class State { Running, Solved, Failed };
  /// Does one step; its nodes, edges and costs are added to the roadmap.
  State step(PlannerHost& host, SharedRoadmap& roadmap);
  /// Does one step without adding it to a roadmap. A later collect() adds it.
  State advance(PlannerHost& host);
  /// Adds the nodes, edges and costs since the last call.
  void collect(SharedRoadmap& roadmap);
  /// Adds the nodes and edges that the planner has grown but not listed yet (Planner::completeRoadmap).
  void complete(SharedRoadmap& roadmap);

  const Planner& planner() const { return *planner_; }
  std::uint64_t randomConfigurations() const { return planner_->counts().randomConfigurations; }
  /// Sum of the counts that collect() has added.
  const PlannerCounts& collected() const { return counted_; }

 private:
  std::unique_ptr<Planner> planner_;
  std::uint64_t samples_;
  SamplingRegionPtr region_;
  std::vector<std::uint32_t> nodeIn_;  ///< index in the shared roadmap for each own node
  std::vector<std::uint32_t> edgeIn_;
  std::size_t droppedTaken_ = 0;
  PlannerCounts counted_;
};

}  // namespace glissade
