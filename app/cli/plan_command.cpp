#include "app/cli/commands.h"

#include <algorithm>
#include <cctype>

#include "app/cli/environment_report.h"
#include "app/cli/interrupt.h"
#include "app/cli/run_output.h"
#include "engine/files/forbidden_places_of.h"
#include "engine/files/path_exporter.h"
#include "engine/files/path_reader.h"
#include "engine/files/run_record.h"
#include "engine/files/scenario_io.h"
#include "engine/operator/device_registry.h"
#include "engine/operator/task_operator.h"
#include "engine/planning/fine/coarse_preview.h"
#include "engine/session/replay_session.h"
#include "engine/session/session.h"
#include "engine/session/session_with_planners.h"
#include "engine/study/benchmarks/peer_planners.h"

namespace glissade::cli {
namespace {

constexpr const char* kReplay = "replay:";

/// The way-points of a simulated operator: those of the path file if one is given, else the scenario's way-points and
/// its goal if it is a configuration.
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

/// Lets the strategy be written in capital letters, as "GTS" in the window.
std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

Outcome checkPlanner(const PlannerRegistry& planners, const std::string& id) {
  if (planners.find(id) != nullptr) return Done{};
  return Diagnostic{ErrorKind::Usage,
                    "",
                    "--strategy",
                    {GLISSADE_TEXT("there is no planner '%1'"), {id}},
                    GLISSADE_TEXT("See 'glissade-cli plan --help' for the planners.")};
}

/// Sets up the recorded run, with the changes that the options make.
Result<std::unique_ptr<LockstepSession>> setUpReplay(const PlanOptions& options, const LoadedScenario& scenario,
                                                     const std::string& file, PlannerRegistry planners,
                                                     const StopToken& stop) {
  const auto record = readRunRecord(file);
  if (!record) return record.error();
  auto log = replayLog(*record, scenario, file, planners);
  if (!log) return log.error();
  ParameterValues trial = log->start.parameters;
  const Outcome parameters = setAll(options.parameters, trial);
  if (!parameters) return parameters.error();
  for (const auto& [id, value] : options.parameters) overrideParameter(id, value, *log);
  if (options.seed) log->start.seed = *options.seed;
  if (options.strategy) log->start.planner = *options.strategy;
  const Outcome planner = checkPlanner(planners, log->start.planner);
  if (!planner) return planner.error();
  const auto problem = withRecordedKnowledge(scenario.problem, *log, stop);
  if (!problem) return problem.error();
  const bool another = !options.parameters.empty() || options.seed || options.strategy;
  return std::unique_ptr<LockstepSession>(makeReplaySession(*problem, std::make_shared<const RunLog>(std::move(*log)),
                                                            another ? ReplayEnd::Continue : ReplayEnd::WithTheLog,
                                                            std::move(planners)));
}

DeviceRegistry simulatedOperators() {
  DeviceRegistry registry = makeDeviceRegistry();
  addTaskOperators(registry);
  return registry;
}

Diagnostic unknownOperator(const std::string& name) {
  return {ErrorKind::Usage,
          "",
          "--operator",
          {GLISSADE_TEXT("there is no operator '%1'"), {name}},
          {GLISSADE_TEXT("Choose one of %1 or replay:FILE."), {operatorNames()}}};
}

/// Sets up the session of a run from the scenario, the options and (for replay) a run record. The options override the
/// record, and the record overrides the scenario.
Result<std::unique_ptr<LockstepSession>> setUpRun(const PlanOptions& options, const LoadedScenario& scenario,
                                                  const StopToken& stop) {
  const std::string& name = options.operatorName;
  const std::string replay = kReplay;
  PlannerRegistry planners = makePlannerRegistryWithPeers();
  if (name.rfind(replay, 0) == 0) {
    return setUpReplay(options, scenario, name.substr(replay.size()), std::move(planners), stop);
  }

  SessionConfig config{scenario.problem, scenario.parameters, scenario.scenario.planner, scenario.scenario.seed,
                       nullptr};
  const Outcome parameters = setAll(options.parameters, config.parameters);
  if (!parameters) return parameters.error();
  if (options.seed) config.seed = *options.seed;
  if (options.strategy) config.plannerId = lowerCase(*options.strategy);
  const Outcome planner = checkPlanner(planners, config.plannerId);
  if (!planner) return planner.error();
  if (name == "none") return makeLockstepSession(std::move(config), std::move(planners));

  const DeviceRegistry registry = simulatedOperators();
  const DeviceEntry* entry = registry.find(name);
  if (entry == nullptr || !entry->simulated) return unknownOperator(name);
  auto route = routeOf(options, scenario);
  if (!route) return route.error();
  config.device =
      entry->make({std::move(*route), scenario.problem.metric(), config.seed, nullptr, scenario.problem.world});
  return makeLockstepSession(std::move(config), std::move(planners));
}

/// Planner steps between two checks for an interruption.
constexpr std::uint64_t kSlice = 200;

/// Plans until the run ends or a person interrupts it.
SnapshotPtr planInLockstep(LockstepSession& session, const Interrupt& interrupt) {
  session.post(command::Start{});
  session.advance(0);
  while (isRunning(*session.snapshot()) && !interrupt.requested()) session.advance(kSlice, interrupt.token());
  if (isRunning(*session.snapshot())) {
    session.post(command::Stop{});
    session.advance(0);
  }
  return session.snapshot();
}

/// Warns of edits without effect. It builds its own environment model, because the planner's counts must not depend on
/// these checks.
void checkEdits(const LoadedScenario& loaded, const Console& console, const StopToken& stop) {
  if (loaded.scenario.places.empty() && loaded.scenario.milestones.empty()) return;
  const auto knowledge = buildSceneKnowledge(loaded.problem, loaded.parameters[ParameterId::RequiredClearance], stop);
  if (!knowledge) return;
  warnOfEdits(loaded, **knowledge, console);
  const auto places = forbiddenPlacesOf((*knowledge)->environment->map, semanticEditsOf(loaded.scenario));
  if (!places) return;  // the run reports the reason
  if (const auto warning = regionsWarning(loaded.scenario, *places, loaded.file)) reportWarnings({*warning}, console);
}

/// Warns of milestones and preferences that the strategy does not use: only strategies that plan coarsely use them.
void warnOfUnused(const PlanOptions& options, const LoadedScenario& loaded) {
  const std::string strategy = options.strategy.value_or(loaded.scenario.planner);
  if (isMultiLayer(strategy)) return;
  const auto prefers = [](const PlaceEdit& edit) { return edit.attributes.count("preference") > 0; };
  const auto& places = loaded.scenario.places;
  Warnings unused;
  const auto warn = [&](const char* location, CatalogueText reason) {
    unused.push_back({ErrorKind::Usage, loaded.file, location, Message(reason, {strategy}),
                      GLISSADE_TEXT("Choose gts to plan with them.")});
  };
  if (!loaded.scenario.milestones.empty()) warn("/milestones", GLISSADE_TEXT("are not used by strategy '%1'"));
  if (std::any_of(places.begin(), places.end(), prefers)) {
    warn("/places", GLISSADE_TEXT("have preferences, which are not used by strategy '%1'"));
  }
  reportWarnings(unused, options.console);
}

/// Checks the output format before the search starts.
Outcome knowsOutput(const PlanOptions& options) {
  if (options.out.empty()) return Done{};
  const auto exporter = pathExporterFor(options.out);
  return exporter ? Outcome(Done{}) : exporter.error();
}

}  // namespace

std::string operatorNames() {
  std::string names = "none";
  const DeviceRegistry registry = simulatedOperators();
  for (const DeviceEntry& entry : registry.entries()) {
    if (entry.simulated) names += ", " + entry.id;
  }
  return names;
}

int runPlan(const PlanOptions& options) {
  if (const Outcome known = knowsOutput(options); !known) return reportError(known.error(), options.console);
  const Interrupt interrupt;
  auto loaded = loadScenario(options.scenario, interrupt.token(), options.fits);
  if (!loaded) return reportError(loaded.error(), options.console);
  reportWarnings(loaded->warnings, options.console);
  reportWarnings(loaded->fits.warnings, options.console);
  if (options.collision != loaded->problem.world->backend()) {
    loaded->problem.world = loaded->problem.world->withBackend(options.collision);
  }
  checkEdits(*loaded, options.console, interrupt.token());
  warnOfUnused(options, *loaded);
  const auto session = setUpRun(options, *loaded, interrupt.token());
  if (!session) return reportError(session.error(), options.console);
  if (!options.console.json) options.console.print({GLISSADE_TEXT("seed %1"), {(*session)->snapshot()->seed}});
  const SnapshotPtr end = planInLockstep(**session, interrupt);
  return deliver(options, *loaded, *end, interrupt.token());
}

}  // namespace glissade::cli
