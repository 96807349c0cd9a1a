#include <limits>

#include "engine/api/outside_planner.h"
#include "engine/api/parameter_map.h"
#include "engine/api/values.h"
#include "engine/operator/simulated_operators.h"
#include "engine/session/run_in_lockstep.h"
#include "engine/session/session_with_planners.h"

namespace glissade::api {
namespace {

RunCounts countsOf(const PlannerCounts& counts) {
  return {counts.steps, counts.nodes, counts.randomConfigurations, counts.queries.collision, counts.queries.distance};
}

/// A run that has not begun.
Run refused(Diagnostic why, const SessionConfig& config) { return {std::move(why), {}, config.plannerId, config.seed}; }

/// The reason why a run has ended without a path.
Diagnostic reasonOf(const SessionSnapshot& end) {
  if (end.problem && end.state == SessionState::Failed) return publicDiagnostic(*end.problem);
  return {ErrorKind::Interrupted, "", "", "the run was stopped", ""};
}

/// `given`: the problem, with the strategy and the seed that count where the options state none.
Run planned(SessionConfig config, const std::vector<glissade::Pose>& route, const PlanOptions& options) {
  if (!options.strategy.empty()) config.plannerId = options.strategy;
  if (options.seed) config.seed = *options.seed;
  if (auto fault = setAll(options.parameters, config.parameters)) return refused(*std::move(fault), config);
  PlannerRegistry planners = makePlannerRegistry();
  std::uint64_t slice = kUsualSlice;
  if (options.planners != nullptr) {
    for (const Planners::Entry& outside : options.planners->added()) {
      planners.add(entryOf(outside));
      if (outside.id == config.plannerId) slice = std::numeric_limits<std::uint64_t>::max();
    }
  }
  if (planners.find(config.plannerId) == nullptr) {
    return refused(wrongArgument("strategy", "there is no planner '" + config.plannerId + "'"), config);
  }
  auto device = makeSimulatedOperator(options.operatorName,
                                      {route, config.problem.metric(), config.seed, nullptr, config.problem.world});
  if (!device) return refused(publicDiagnostic(device.error()), config);
  config.device = std::move(device).value();
  const glissade::Problem problem = config.problem;
  const auto session = makeLockstepSession(std::move(config), std::move(planners));
  const SnapshotPtr end = runInLockstep(*session, options.stop, slice, [&](const SessionSnapshot& now) {
    if (options.progress) options.progress(countsOf(now.counts));
  });
  auto path = end->path ? Result<Path>(publicPath(*end->path, end->provenance, problem.world.get()))
                        : Result<Path>(reasonOf(*end));
  return {std::move(path), countsOf(end->counts), end->plannerId, end->seed, end->planningSeconds};
}

/// planned(), with exceptions as diagnostics.
Run guardedPlan(SessionConfig config, const std::vector<glissade::Pose>& route, const PlanOptions& options) {
  const std::string strategy = config.plannerId;
  try {
    return planned(std::move(config), route, options);
  } catch (...) {
    return {publicDiagnostic(currentExceptionAsDiagnostic(Message("planning"))), {}, strategy};
  }
}

}  // namespace

Run plan(const Problem& problem, const PlanOptions& options) {
  const Problem::Impl& given = problem.impl();
  std::vector<glissade::Pose> route;
  if (const auto* goal = std::get_if<glissade::Pose>(&given.problem.goal)) route.push_back(*goal);
  return guardedPlan({given.problem, given.parameters, "auto", 1, nullptr}, route, options);
}

Run plan(const Scenario& scenario, const PlanOptions& options) {
  const LoadedScenario& loaded = *scenario.impl().loaded;
  return guardedPlan({loaded.problem, loaded.parameters, loaded.scenario.planner, loaded.scenario.seed, nullptr},
                     routeOf(loaded), options);
}

}  // namespace glissade::api
