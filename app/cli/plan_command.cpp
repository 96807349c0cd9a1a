#include "app/cli/plan_command.h"

#include <algorithm>
#include <iostream>

#include "app/cli/environment_report.h"
#include "app/cli/interrupt.h"
#include "app/cli/run_output.h"
#include "app/cli/run_setup.h"
#include "engine/planning/fine/coarse_preview.h"
#include "engine/scenario/forbidden_places_of.h"
#include "engine/scenario/path_exporter.h"
#include "engine/scenario/scenario_io.h"

namespace glissade::cli {
namespace {

/// Planner steps between two looks at the clock of the outside world.
constexpr std::uint64_t kSlice = 200;

/// Plans until the run ends or somebody interrupts it.
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

/// The planner makes an environment model of its own, or none: its counts must not depend on what is asked here.
void checkEdits(const LoadedScenario& loaded, const StopToken& stop) {
  if (loaded.scenario.places.empty() && loaded.scenario.milestones.empty()) return;
  const auto knowledge = buildSceneKnowledge(loaded.problem, loaded.parameters[ParameterId::RequiredClearance], stop);
  if (!knowledge) return;
  warnOfEdits(loaded, **knowledge);
  const auto places = forbiddenPlacesOf((*knowledge)->environment->map, semanticEditsOf(loaded.scenario));
  if (!places) return;  // the run says why
  if (const auto warning = regionsWarning(loaded.scenario, *places, loaded.file)) reportWarnings({*warning});
}

/// Only strategies that plan coarsely look at milestones and preferences.
void warnOfUnused(const PlanOptions& options, const LoadedScenario& loaded) {
  const std::string strategy = options.strategy.value_or(loaded.scenario.planner);
  if (isMultiLayer(strategy)) return;
  const auto prefers = [](const PlaceEdit& edit) { return edit.attributes.count("preference") > 0; };
  const auto& places = loaded.scenario.places;
  Warnings unused;
  const auto warn = [&](const char* location, const char* what) {
    unused.push_back({ErrorKind::Usage, loaded.file, location,
                      std::string(what) + " not used by strategy '" + strategy + "'", "Choose gts to plan with them."});
  };
  if (!loaded.scenario.milestones.empty()) warn("/milestones", "are");
  if (std::any_of(places.begin(), places.end(), prefers)) warn("/places", "have preferences, which are");
  reportWarnings(unused);
}

/// Asked first, not after the whole search.
Outcome knowsOutput(const PlanOptions& options) {
  if (options.out.empty()) return Done{};
  const auto exporter = pathExporterFor(options.out);
  return exporter ? Outcome(Done{}) : exporter.error();
}

}  // namespace

int runPlan(const PlanOptions& options) {
  if (const Outcome known = knowsOutput(options); !known) return reportError(known.error(), options.format);
  const Interrupt interrupt;
  auto loaded = loadScenario(options.scenario, options.fits, interrupt.token());
  if (!loaded) return reportError(loaded.error(), options.format);
  reportWarnings(loaded->warnings);
  reportWarnings(loaded->fits.warnings);
  if (options.collision != loaded->problem.world->backend()) {
    loaded->problem.world = loaded->problem.world->withBackend(options.collision);
  }
  checkEdits(*loaded, interrupt.token());
  warnOfUnused(options, *loaded);
  const auto session = setUpRun(options, *loaded, interrupt.token());
  if (!session) return reportError(session.error(), options.format);
  if (options.format == Format::Text) std::cout << "seed " << (*session)->snapshot()->seed << "\n";
  const SnapshotPtr end = planInLockstep(**session, interrupt);
  return deliver(options, *loaded, *end, interrupt.token());
}

}  // namespace glissade::cli
