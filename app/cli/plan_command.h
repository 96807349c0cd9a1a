#pragma once

#include <map>
#include <optional>
#include <string>

#include "app/cli/report.h"
#include "engine/scenario/fit_options.h"

namespace glissade::cli {

struct PlanOptions {
  std::string scenario;
  std::optional<std::string> strategy;  ///< planner id; the scenario's where absent
  CollisionBackend collision = CollisionBackend::Kernel;
  std::string operatorName = "none";         ///< none, novice, default, expert, task-expert, ... or replay:FILE
  std::string way;                           ///< path file that a simulated operator's way-points are of; empty: none
  std::map<ParameterId, double> parameters;  ///< what overrides the scenario's
  FitOptions fits;
  std::optional<std::uint64_t> seed;
  std::string out;          ///< path file to write, format by its ending; empty: none
  std::string record;       ///< run record to write; empty: none
  bool edges = false;       ///< certificates of every edge
  bool difficulty = false;  ///< where no path is found: what stood in the way
  Format format = Format::Text;
};

/// glissade-cli plan: plans in lockstep and delivers a certified path. Exit code 0 solved, 5 limit
/// reached, 4 start or goal in collision, 130 interrupted.
int runPlan(const PlanOptions& options);

}  // namespace glissade::cli
