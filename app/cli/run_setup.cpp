#include "app/cli/run_setup.h"

#include <algorithm>
#include <cctype>

#include "engine/operator/device_registry.h"
#include "engine/operator/task_operator.h"
#include "engine/scenario/path_reader.h"
#include "engine/scenario/run_record.h"
#include "engine/session/replay_session.h"

namespace glissade::cli {
namespace {

constexpr const char* kReplay = "replay:";

/// The way of a simulated operator: that of a path, where one is given; else the scenario's way-points, then the goal
/// if it is a configuration.
Result<std::vector<Pose>> routeOf(const PlanOptions& options, const LoadedScenario& scenario) {
  if (!options.way.empty()) {
    const auto points = readPath(options.way);
    if (!points) return points.error();
    std::vector<Pose> path;
    for (const PathPoint& point : *points) path.push_back(point.q);
    return taskRoute(path, scenario.problem.metric());
  }
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

/// "GTS" is what the window calls gts.
std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

Outcome checkPlanner(const std::string& id) {
  if (makePlannerRegistry().find(id) != nullptr) return Done{};
  return Diagnostic{ErrorKind::Usage, "", "--strategy", "there is no planner '" + id + "'",
                    "See 'glissade-cli plan --help' for the planners."};
}

/// The recorded run again, or with what the options change.
Result<std::unique_ptr<LockstepSession>> setUpReplay(const PlanOptions& options, const LoadedScenario& scenario,
                                                     const std::string& file, const StopToken& stop) {
  const auto record = readRunRecord(file);
  if (!record) return record.error();
  auto log = replayLog(*record, scenario, file);
  if (!log) return log.error();
  ParameterValues trial = log->start.parameters;
  const Outcome parameters = setAll(options.parameters, trial);
  if (!parameters) return parameters.error();
  for (const auto& [id, value] : options.parameters) overrideParameter(id, value, *log);
  if (options.seed) log->start.seed = *options.seed;
  if (options.strategy) log->start.planner = *options.strategy;
  const Outcome planner = checkPlanner(log->start.planner);
  if (!planner) return planner.error();
  const auto problem = withRecordedKnowledge(scenario.problem, *log, stop);
  if (!problem) return problem.error();
  const bool another = !options.parameters.empty() || options.seed || options.strategy;
  return std::unique_ptr<LockstepSession>(makeReplaySession(*problem, std::make_shared<const RunLog>(std::move(*log)),
                                                            another ? ReplayEnd::GoOn : ReplayEnd::WithTheLog));
}

DeviceRegistry simulatedOperators() {
  DeviceRegistry registry = makeDeviceRegistry();
  addTaskOperators(registry);
  return registry;
}

Diagnostic unknownOperator(const std::string& name) {
  std::string known = "none";
  const DeviceRegistry registry = simulatedOperators();
  for (const DeviceEntry& entry : registry.entries()) {
    if (entry.simulated) known += ", " + entry.id;
  }
  return {ErrorKind::Usage, "", "--operator", "there is no operator '" + name + "'",
          "Choose one of " + known + " or replay:FILE."};
}

}  // namespace

Result<std::unique_ptr<LockstepSession>> setUpRun(const PlanOptions& options, const LoadedScenario& scenario,
                                                  const StopToken& stop) {
  const std::string& name = options.operatorName;
  const std::string replay = kReplay;
  if (name.rfind(replay, 0) == 0) return setUpReplay(options, scenario, name.substr(replay.size()), stop);

  SessionConfig config{scenario.problem, scenario.parameters, scenario.scenario.planner, scenario.scenario.seed,
                       nullptr};
  const Outcome parameters = setAll(options.parameters, config.parameters);
  if (!parameters) return parameters.error();
  if (options.seed) config.seed = *options.seed;
  if (options.strategy) config.plannerId = lowerCase(*options.strategy);
  const Outcome planner = checkPlanner(config.plannerId);
  if (!planner) return planner.error();
  if (name == "none") return makeLockstepSession(std::move(config));

  const DeviceRegistry registry = simulatedOperators();
  const DeviceEntry* entry = registry.find(name);
  if (entry == nullptr || !entry->simulated) return unknownOperator(name);
  auto route = routeOf(options, scenario);
  if (!route) return route.error();
  config.device =
      entry->make({std::move(*route), scenario.problem.metric(), config.seed, nullptr, scenario.problem.world});
  return makeLockstepSession(std::move(config));
}

}  // namespace glissade::cli
