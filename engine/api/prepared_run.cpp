#include "engine/api/prepared_run.h"

#include <utility>
#include <vector>

#include "engine/api/outside_operator.h"
#include "engine/api/outside_planner.h"
#include "engine/api/outside_sampler.h"
#include "engine/api/parameter_map.h"
#include "engine/operator/simulated_operators.h"
#include "engine/session/session_with_planners.h"

namespace glissade::api {
namespace {

/// `given`: the problem, with the strategy and the seed that count where the options state none. `route`: the way that
/// a simulated operator knows.
Result<PreparedRunPtr> prepared(SessionConfig given, const std::vector<glissade::Pose>& route,
                                const PlanOptions& options) {
  if (!options.strategy.empty()) given.plannerId = options.strategy;
  if (options.seed) given.seed = *options.seed;
  if (auto fault = setAll(options.parameters, given.parameters)) return *std::move(fault);
  if (options.sampler)
    given.problem.source = sourceOf(options.sampler, valueOf<Problem>({given.problem, given.parameters}));
  auto run = std::make_shared<PreparedRun>(PreparedRun{given.problem});
  PlannerRegistry planners = makePlannerRegistry();
  if (options.planners != nullptr) {
    for (const Planners::Entry& outside : options.planners->added()) {
      planners.add(entryOf(outside));
      run->isFromOutside = run->isFromOutside || outside.id == given.plannerId;
    }
  }
  if (planners.find(given.plannerId) == nullptr) {
    return wrongArgument("strategy", "there is no planner '" + given.plannerId + "'");
  }
  if (options.operatorFunction) {
    given.device = deviceOf(options.operatorFunction);
  } else {
    auto device = makeSimulatedOperator(options.operatorName,
                                        {route, given.problem.metric(), given.seed, nullptr, given.problem.world});
    if (!device) return publicDiagnostic(device.error());
    given.device = std::move(device).value();
  }
  run->session = makeLockstepSession(std::move(given), std::move(planners));
  return run;
}

}  // namespace

Result<PreparedRunPtr> preparedRun(const Problem& problem, const PlanOptions& options) {
  const Problem::Impl& given = problem.impl();
  std::vector<glissade::Pose> route;
  if (const auto* goal = std::get_if<glissade::Pose>(&given.problem.goal)) route.push_back(*goal);
  return prepared({given.problem, given.parameters, "auto", 1, nullptr}, route, options);
}

Result<PreparedRunPtr> preparedRun(const Scenario& scenario, const PlanOptions& options) {
  const LoadedScenario& loaded = *scenario.impl().loaded;
  return prepared({loaded.problem, loaded.parameters, loaded.scenario.planner, loaded.scenario.seed, nullptr},
                  routeOf(loaded), options);
}

RunCounts publicCounts(const PlannerCounts& counts) {
  return {counts.steps, counts.nodes, counts.randomConfigurations, counts.queries.collision, counts.queries.distance};
}

Result<Path> endOf(const PreparedRun& run, const SessionSnapshot& now) {
  if (now.problem) return publicDiagnostic(*now.problem);
  if (now.path) return publicPath(*now.path, now.provenance, run.problem.world.get());
  return Diagnostic{ErrorKind::Interrupted, "", "", "the run was stopped", ""};
}

}  // namespace glissade::api
