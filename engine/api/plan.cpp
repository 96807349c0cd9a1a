#include <limits>

#include "engine/api/prepared_run.h"
#include "engine/session/run_in_lockstep.h"

namespace glissade::api {
namespace {

/// The run of a problem or a scenario. Exceptions are diagnostics.
template <class Task>
Run planned(const Task& task, const PlanOptions& options) {
  try {
    const auto prepared = preparedRun(task, options);
    if (!prepared) return {prepared.error(), {}, options.strategy, options.seed.value_or(0)};
    PreparedRun& run = **prepared;
    // A function cannot go on where it has returned, so that its run is one slice.
    const std::uint64_t slice = run.isFromOutside ? std::numeric_limits<std::uint64_t>::max() : kUsualSlice;
    const SnapshotPtr end = runInLockstep(*run.session, options.stop, slice, [&](const SessionSnapshot& now) {
      if (options.progress) options.progress(publicCounts(now.counts));
    });
    return {endOf(run, *end), publicCounts(end->counts), end->plannerId, end->seed, end->planningSeconds};
  } catch (...) {
    return {publicDiagnostic(currentExceptionAsDiagnostic(Message("planning"))), {}, options.strategy};
  }
}

}  // namespace

Run plan(const Problem& problem, const PlanOptions& options) { return planned(problem, options); }

Run plan(const Scenario& scenario, const PlanOptions& options) { return planned(scenario, options); }

}  // namespace glissade::api
