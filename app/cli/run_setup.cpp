#include "app/cli/run_setup.h"

#include "engine/operator/device_registry.h"
#include "engine/operator/recorded_device.h"

namespace glissade::cli {
namespace {

constexpr const char* kReplay = "replay:";

/// The way of a simulated operator: the scenario's way-points, then the goal if it is a configuration.
std::vector<Pose> routeOf(const LoadedScenario& scenario) {
  std::vector<Pose> route = scenario.scenario.wayPoints;
  if (const Pose* goal = std::get_if<Pose>(&scenario.problem.goal)) route.push_back(*goal);
  return route;
}

Outcome setAll(const std::map<ParameterId, double>& values, ParameterValues& parameters) {
  for (const auto& [id, value] : values) {
    const Outcome outcome = parameters.set(id, value);
    if (!outcome) return outcome;
  }
  return Done{};
}

Outcome useRecord(const RunRecord& record, RunSetup& setup) {
  const Outcome parameters = setAll(record.parameters, setup.config.parameters);
  if (!parameters) return parameters;
  setup.config.seed = record.seed;
  setup.config.plannerId = record.planner;
  setup.parameterChanges = record.parameterChanges;
  if (record.hadOperator) setup.config.device = std::make_unique<RecordedDevice>(record.operatorStream);
  return Done{};
}

Diagnostic unknownOperator(const std::string& name) {
  std::string known = "none";
  const DeviceRegistry registry = makeDeviceRegistry();
  for (const DeviceEntry& entry : registry.entries()) {
    if (entry.simulated) known += ", " + entry.id;
  }
  return {ErrorKind::Usage, "", "--operator", "there is no operator '" + name + "'",
          "Choose one of " + known + " or replay:FILE."};
}

}  // namespace

Result<RunSetup> setUpRun(const PlanOptions& options, const LoadedScenario& scenario) {
  RunSetup setup{{scenario.problem, scenario.parameters, scenario.scenario.planner, scenario.scenario.seed, nullptr},
                 {}};
  if (options.collision != scenario.problem.world->backend()) {
    setup.config.problem.world = scenario.problem.world->withBackend(options.collision);
  }
  const std::string& name = options.operatorName;
  const bool replays = name.rfind(kReplay, 0) == 0;
  if (replays) {
    const auto record = readRunRecord(name.substr(std::string(kReplay).size()));
    if (!record) return record.error();
    const Outcome used = useRecord(*record, setup);
    if (!used) return used.error();
  }
  const Outcome parameters = setAll(options.parameters, setup.config.parameters);
  if (!parameters) return parameters.error();
  if (options.seed) setup.config.seed = *options.seed;
  if (options.strategy) setup.config.plannerId = *options.strategy;
  const PlannerRegistry planners = makePlannerRegistry();
  if (planners.find(setup.config.plannerId) == nullptr) {
    return Diagnostic{ErrorKind::Usage, "", "--strategy", "there is no planner '" + setup.config.plannerId + "'",
                      "See 'glissade-cli plan --help' for those there are."};
  }
  if (replays || name == "none") return setup;

  const DeviceRegistry registry = makeDeviceRegistry();
  const DeviceEntry* entry = registry.find(name);
  if (entry == nullptr || !entry->simulated) return unknownOperator(name);
  setup.config.device = entry->make({routeOf(scenario), scenario.problem.metric(), setup.config.seed, nullptr});
  return setup;
}

}  // namespace glissade::cli
