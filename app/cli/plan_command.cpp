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
#include "engine/operator/simulated_operators.h"
#include "engine/operator/task_operator.h"
#include "engine/planning/fine/coarse_preview.h"
#include "engine/session/replay_session.h"
#include "engine/session/run_in_lockstep.h"
#include "engine/session/session.h"
#include "engine/session/session_with_planners.h"
#include "engine/study/benchmarks/peer_planners.h"

namespace glissade::cli {
namespace {

constexpr const char* kReplay = "replay:";

/// The way-points of a simulated operator: those of the path file if one is given, else those of the scenario.
Result<std::vector<Pose>> routeFor(const PlanOptions& options, const LoadedScenario& scenario) {
  if (options.way.empty()) return routeOf(scenario);
  const auto points = readPath(options.way);
  if (!points) return points.error();
  return taskRoute(configurationsOf(*points), scenario.problem.metric());
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
  if (name == kNoOperator) return makeLockstepSession(std::move(config), std::move(planners));
  auto route = routeFor(options, scenario);
  if (!route) return route.error();
  auto device = makeSimulatedOperator(
      name, {std::move(*route), scenario.problem.metric(), config.seed, nullptr, scenario.problem.world});
  if (!device) {
    Diagnostic why = device.error();
    why.location = "--operator";
    why.advice = {GLISSADE_TEXT("Choose one of %1 or replay:FILE."), {simulatedOperatorNames()}};
    return why;
  }
  config.device = std::move(*device);
  return makeLockstepSession(std::move(config), std::move(planners));
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
  const SnapshotPtr end = runInLockstep(**session, interrupt.token());
  return deliver(options, *loaded, *end, interrupt.token());
}

}  // namespace glissade::cli
