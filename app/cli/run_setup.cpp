#include "app/cli/run_setup.h"

#include <algorithm>
#include <cctype>

#include "engine/operator/device_registry.h"
#include "engine/scenario/run_record.h"
#include "engine/session/replay_session.h"

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

  const DeviceRegistry registry = makeDeviceRegistry();
  const DeviceEntry* entry = registry.find(name);
  if (entry == nullptr || !entry->simulated) return unknownOperator(name);
  config.device =
      entry->make({routeOf(scenario), scenario.problem.metric(), config.seed, nullptr, scenario.problem.world});
  return makeLockstepSession(std::move(config));
}

}  // namespace glissade::cli
