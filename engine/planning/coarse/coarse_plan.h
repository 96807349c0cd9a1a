#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/message.h"
#include "engine/planning/coarse/strategy_rules.h"
#include "engine/planning/path.h"
#include "engine/planning/sampling_region.h"

namespace glissade {

struct EnvironmentModel;

/// The topological graph of paper 2 (section 3.2). Its nodes are the borders, and S and G of the query. An edge crosses
/// one place between two of its borders.
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
    double distance = 0.0;  ///< d_k: distance between the two nodes, metres
    double cost = 0.0;      ///< C_e of equation (1); infinite: the place is forbidden
  };
  std::vector<Node> nodes;
  std::vector<Edge> edges;
};

enum class StepResult { Pending, Running, Solved, Failed };

/// A place to cross and a border to reach (paper 2, section 4.1), with the result.
struct TopologicalStep {
  static constexpr int kWholeWorkspace = -1;  ///< the last resort, a search of the whole workspace from start to goal

  int place = 0;    ///< index of the place to cross, or kWholeWorkspace
  int border = -1;  ///< border to reach; -1: the goal
  std::string placeName;
  std::string borderName;  ///< "G" for the goal
  Pose from;
  Pose to;  ///< the milestone in the border; undefined while `milestone` is false
  bool milestone = false;
  bool geometrical = false;                ///< the geometrical planner was asked for a region
  std::string planner;                     ///< id of the local planner; empty: not chosen yet
  Message why;                             ///< "place 3: complexity 3, cluttered, so geometrical planner then rrt"
  std::uint64_t randomConfigurations = 0;  ///< random configurations of milestone and local planner together
  StepResult result = StepResult::Pending;
  SamplingRegionPtr region;       ///< region of the geometrical planner, or the place with its borders
  std::vector<PathPoint> points;  ///< the trajectory of a solved step
};

/// The inputs of a coarse plan. The plan is valid for these inputs only.
struct PlanBasis {
  std::shared_ptr<const EnvironmentModel> environment;  ///< model whose places and borders the plan's indices refer to
  std::shared_ptr<const SemanticEdits> edits;           ///< null: none
  StrategyRules rules;
};

/// The decisions of the coarse planning and the progress of the fine planning. Published as a whole, never changed.
struct CoarsePlan {
  PlanBasis basis;
  std::uint64_t attempt = 0;  ///< number of coarse paths tried
  std::shared_ptr<const TopologicalGraph> graph;
  std::vector<int> nodes;  ///< nodes of the graph from S to G; empty: there is no way
  double cost = 0.0;
  std::vector<TopologicalStep> steps;
  std::vector<std::string> forbidden;      ///< forbidden places, where there is no way
  std::vector<std::string> infiniteCost;   ///< other places and borders of infinite cost, where there is no way
  std::uint64_t coarseConfigurations = 0;  ///< configurations drawn for milestones and probes
  std::uint64_t fineConfigurations = 0;    ///< configurations drawn by local planners
};
using CoarsePlanPtr = std::shared_ptr<const CoarsePlan>;

}  // namespace glissade
