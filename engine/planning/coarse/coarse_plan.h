#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/planning/coarse/strategy_rules.h"
#include "engine/planning/path.h"
#include "engine/planning/sampling_region.h"

namespace glissade {

struct EnvironmentModel;

/// The topological graph of paper 2 (section 3.2): nodes are borders, and S and G of the query; an
/// edge crosses one place between two of its borders.
struct TopologicalGraph {
  static constexpr int kStart = 0;  ///< index of node S
  static constexpr int kGoal = 1;   ///< index of node G

  struct Node {
    int border = -1;  ///< index into TopologicalMap::borders; -1 for S and G
    Vector3 p_W = Vector3::Zero();
    double cost = 0.0;  ///< C_n of equation (1); zero for S and G
  };
  struct Edge {
    int from = 0;
    int to = 0;
    int place = 0;
    double distance = 0.0;  ///< d_k: between the two nodes, metres
    double cost = 0.0;      ///< C_e of equation (1); infinite: the place is forbidden
  };
  std::vector<Node> nodes;
  std::vector<Edge> edges;
};

enum class StepResult { Pending, Running, Solved, Failed };

/// A place to cross and a border to reach (paper 2, section 4.1), with what became of it.
struct TopologicalStep {
  static constexpr int kWholeWorkspace = -1;  ///< the last resort, from start to goal

  int place = 0;    ///< index of the place to cross; kWholeWorkspace: none in particular
  int border = -1;  ///< to reach; -1: the goal
  std::string placeName;
  std::string borderName;  ///< "G" for the goal
  Pose from;
  Pose to;  ///< the milestone in the border; meaningless while `milestone` is false
  bool milestone = false;
  bool geometrical = false;                ///< the geometrical planner was asked for a region
  std::string planner;                     ///< id of the local planner; empty: not chosen yet
  std::string why;                         ///< "place 3: complexity 3, cluttered, so geometrical planner then rrt"
  std::uint64_t randomConfigurations = 0;  ///< milestone and local planner together
  StepResult result = StepResult::Pending;
  SamplingRegionPtr region;       ///< of the geometrical planner, or the place with its borders
  std::vector<PathPoint> points;  ///< the trajectory of a solved step
};

/// What a coarse plan was made from: for anything else it means nothing.
struct PlanBasis {
  std::shared_ptr<const EnvironmentModel> environment;  ///< whose places and borders the plan's indices are
  std::shared_ptr<const SemanticEdits> edits;           ///< null: none
  StrategyRules rules;
};

/// What the coarse planning has decided and how far the fine planning is; published whole, never
/// changed.
struct CoarsePlan {
  PlanBasis basis;
  std::uint64_t attempt = 0;  ///< counts the coarse paths tried
  std::shared_ptr<const TopologicalGraph> graph;
  std::vector<int> nodes;  ///< of the graph, from S to G; empty: there is no way
  double cost = 0.0;
  std::vector<TopologicalStep> steps;
  std::vector<std::string> forbidden;      ///< where there is no way: the places that are forbidden
  std::vector<std::string> infiniteCost;   ///< where there is no way: what else costs infinitely much
  std::uint64_t coarseConfigurations = 0;  ///< drawn for milestones and probes
  std::uint64_t fineConfigurations = 0;    ///< drawn by local planners
};
using CoarsePlanPtr = std::shared_ptr<const CoarsePlan>;

}  // namespace glissade
