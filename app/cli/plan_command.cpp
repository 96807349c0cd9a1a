#include "app/cli/plan_command.h"

#include <algorithm>
#include <iostream>

#include "app/cli/interrupt.h"
#include "app/cli/run_output.h"
#include "app/cli/run_setup.h"
#include "engine/scenario/scenario_io.h"

namespace glissade::cli {
namespace {

/// Planner steps between two looks at the clock of the outside world.
constexpr std::uint64_t kSlice = 200;

/// Plans until the run ends or somebody interrupts it; parameters change at the recorded steps.
SnapshotPtr planInLockstep(LockstepSession& session, const std::vector<RunRecord::ParameterChange>& changes,
                           const Interrupt& interrupt) {
  session.post(command::Start{});
  session.advance(0);
  auto change = changes.begin();
  while (isRunning(*session.snapshot()) && !interrupt.requested()) {
    const std::uint64_t done = session.snapshot()->counts.steps;
    for (; change != changes.end() && change->step <= done; ++change) {
      session.post(command::SetParameter{change->id, change->value});
    }
    session.advance(change == changes.end() ? kSlice : std::min(kSlice, change->step - done), interrupt.token());
  }
  if (isRunning(*session.snapshot())) {
    session.post(command::Stop{});
    session.advance(0);
  }
  return session.snapshot();
}

}  // namespace

int runPlan(const PlanOptions& options) {
  const Interrupt interrupt;
  auto loaded = loadScenario(options.scenario);
  if (!loaded) return reportError(loaded.error(), options.format);
  reportWarnings(loaded->warnings);
  auto setup = setUpRun(options, *loaded);
  if (!setup) return reportError(setup.error(), options.format);

  const auto session = makeLockstepSession(std::move(setup->config));
  if (options.format == Format::Text) std::cout << "seed " << session->snapshot()->seed << "\n";
  const SnapshotPtr end = planInLockstep(*session, setup->parameterChanges, interrupt);
  return deliver(options, *loaded, *end);
}

}  // namespace glissade::cli
