#include "app/cli/commands.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/interrupt.h"
#include "engine/base/time_limit.h"
#include "engine/check/read_path.h"
#include "engine/check/read_question.h"
#include "engine/check/verdict_report.h"
#include "engine/files/forbidden_places_of.h"

namespace glissade::cli {
namespace {

/// Shows on the terminal which share of the work is done.
class CheckProgress {
 public:
  explicit CheckProgress(const Console& console)
      : console_(console), shown_(!console.json && isatty(STDERR_FILENO) != 0) {}
  ~CheckProgress() {
    if (percent_ >= 0) std::cerr << "\r\033[K" << std::flush;
  }
  CheckProgress(const CheckProgress&) = delete;
  CheckProgress& operator=(const CheckProgress&) = delete;

  void show(double share) {
    const int percent = static_cast<int>(100.0 * share);
    if (!shown_ || percent == percent_) return;
    percent_ = percent;
    std::cerr << "\r\033[K" << console_.text({GLISSADE_TEXT("%1 % checked"), {percent}}) << std::flush;
  }

 private:
  Console console_;
  bool shown_;
  int percent_ = -1;
};

/// The exit code is 0 for a valid path or plan. A refusal that was shown counts more than a stop. Shapes that files
/// state and that are no bodies make the verdict conditional: they may be in the way.
int exitCodeOf(bool valid, bool refused, const MissingShapes& missing, const Interrupt& interrupt,
               const StopToken& stop) {
  if (valid && !missing.empty()) return kExitUnderConditions;
  if (valid) return 0;
  if (!refused && interrupt.requested()) return exitCode(ErrorKind::Interrupted);
  if (!refused && stop.stopRequested()) return exitCode(ErrorKind::LimitReached);
  return exitCode(ErrorKind::NoPath);
}

/// Reports the error. A reader that the time limit stopped reports Interrupted; this becomes LimitReached.
int reportStopped(Diagnostic error, const Interrupt& interrupt, const Console& console) {
  if (error.kind == ErrorKind::Interrupted && !interrupt.requested()) error.kind = ErrorKind::LimitReached;
  return reportError(error, console);
}

int checkPath(const CheckOptions& options, const Interrupt& interrupt, const StopToken& stop) {
  if (!options.without.empty()) {
    return reportError({ErrorKind::Usage, options.scenario, "--without",
                        GLISSADE_TEXT("is for assembly plans: a path is of a scenario"),
                        GLISSADE_TEXT("Remove the body from the scenario.")},
                       options.console);
  }
  if (options.trustPlan) {
    return reportError({ErrorKind::Usage, options.scenario, "--trust-plan",
                        GLISSADE_TEXT("is for assembly plans: a path states no decisions of the user"),
                        GLISSADE_TEXT("Leave it out.")},
                       options.console);
  }
  const auto path = check::readPath(options.path);
  if (!path) return reportError(path.error(), options.console);
  auto question = check::readQuestion(options.scenario, options.fits, stop);
  if (!question) return reportStopped(question.error(), interrupt, options.console);
  const Outcome found = addForbiddenPlaces(options.scenario, stop, *question);
  reportWarnings(question->product.warnings, options.console);
  if (!found) return reportStopped(found.error(), interrupt, options.console);
  if (options.requiredClearance) {
    ParameterValues parameters(radiusAboutOrigin(*question->object().mesh));
    const Outcome set = parameters.set(ParameterId::RequiredClearance, *options.requiredClearance);
    if (!set) return reportError(set.error(), options.console);
    question->requiredClearance = *options.requiredClearance;
  }
  check::PathVerdict verdict;
  {
    CheckProgress progress(options.console);
    verdict = check::judgePath(*question, *path, {stop, [&](double share) { progress.show(share); }});
  }
  if (options.console.json) {
    printJson(check::reportJson(verdict, *question, options.edges));
  } else {
    std::cout << check::reportText(verdict, *question, options.edges, options.console.language);
  }
  return exitCodeOf(verdict.valid(), verdict.refused(), question->product.missing, interrupt, stop);
}

int checkPlan(const CheckOptions& options, const Interrupt& interrupt, const StopToken& stop) {
  const auto plan = check::readPlan(options.path);
  if (!plan) return reportError(plan.error(), options.console);
  auto product =
      check::readProduct(options.scenario, plan->deflection, options.fits, stop, {options.open, plan->bodies});
  if (!product) return reportStopped(product.error(), interrupt, options.console);
  if (const Outcome left = check::leaveOut(options.without, *product); !left) {
    return reportError(left.error(), options.console);
  }
  reportWarnings(product->warnings, options.console);
  if (product->forbidsPlaces) reportWarnings({placesHoldForPathsOnly(options.scenario)}, options.console);
  check::PlanVerdict verdict;
  {
    CheckProgress progress(options.console);
    verdict = check::judgePlan(*product, *plan, options.requiredClearance,
                               {stop, [&](double share) { progress.show(share); }}, options.lanes);
  }
  verdict.planIsTrusted = options.trustPlan;
  if (options.console.json) {
    printJson(check::reportJson(verdict, *product));
  } else {
    std::cout << check::reportText(verdict, *product, options.console.language);
  }
  const check::PlanOutcome outcome = verdict.outcome();
  if (outcome == check::PlanOutcome::Incomplete) return exitCode(ErrorKind::NoPath);
  if (outcome == check::PlanOutcome::Conditional) return kExitUnderConditions;
  if (verdict.valid() && verdict.stepsWithoutProof() > 0) return kExitWithoutProof;
  return exitCodeOf(verdict.valid(), verdict.refused(), product->missing, interrupt, stop);
}

}  // namespace

int runCheck(const CheckOptions& options) {
  if (!(options.timeLimit >= 0.0)) {
    return reportError({ErrorKind::Usage, "", "--time-limit", GLISSADE_TEXT("is below zero"),
                        GLISSADE_TEXT("Give seconds, 0 for none.")},
                       options.console);
  }
  const Interrupt interrupt;
  const StopToken stop = withTimeLimit(interrupt.token(), options.timeLimit);
  return check::isPlan(options.path) ? checkPlan(options, interrupt, stop) : checkPath(options, interrupt, stop);
}

}  // namespace glissade::cli
