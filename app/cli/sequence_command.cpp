#include "app/cli/commands.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/interrupt.h"
#include "app/cli/plan_conditions.h"
#include "app/cli/plan_printer.h"
#include "app/cli/text_cells.h"
#include "engine/base/number_text.h"
#include "engine/base/quantity_text.h"
#include "engine/base/time_limit.h"
#include "engine/base/version_text.h"
#include "engine/check/plain_overlaps.h"
#include "engine/files/fits_cache.h"
#include "engine/files/plan_file.h"
#include "engine/files/product_file.h"
#include "engine/fits/alternatives.h"
#include "engine/fits/joint_edits.h"
#include "engine/fits/joint_finder.h"
#include "engine/import/missing_shapes_json.h"

#include "engine/sequence/fasteners.h"
#include "engine/sequence/plan_bodies.h"
#include "engine/sequence/product_changes.h"
#include "engine/sequence/product_finder.h"
#include "engine/sequence/sequence_run.h"
#include "engine/sequence/stated_units.h"
#include "engine/sequence/step_motion.h"
#include "engine/sequence/subassembly_lines.h"

namespace glissade::cli {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// Writes lines on standard error about the progress of a run that began at this time.
class ProgressNotes {
 public:
  ProgressNotes(Clock::time_point begin, const Console& console) : begin_(begin), console_(console) {}

  void note(const Message& line) const {
    console_.note({GLISSADE_TEXT("%1 s: %2"), {fixedDigits(secondsSince(begin_), 1), line}});
  }

 private:
  Clock::time_point begin_;
  Console console_;
};

/// Writes every few seconds the share of the compared pairs of bodies.
class FitProgress {
 public:
  explicit FitProgress(const ProgressNotes& notes) : notes_(notes), shown_(Clock::now()) {}

  void show(double share) {
    constexpr double kEvery = 5.0;
    if (secondsSince(shown_) < kEvery) return;
    shown_ = Clock::now();
    notes_.note({GLISSADE_TEXT("comparing pairs of bodies, %1 %"), {std::lround(100.0 * share)}});
  }

 private:
  ProgressNotes notes_;
  Clock::time_point shown_;
};

/// Prints a line on standard error for each step that is found and for each search.
class ProgressHost final : public SequenceHost {
 public:
  ProgressHost(StopToken stop, ThreadTeam& team, const AssembledProduct& product, const ProgressNotes& notes)
      : stop_(std::move(stop)), team_(team), product_(product), notes_(notes) {}

  const StopToken& stopToken() const override { return stop_; }
  ThreadTeam& team() override { return team_; }

  /// From now on the plan is written every few seconds. `deflection`: as AssemblyPlan::deflection.
  void keepIn(const SequenceOptions& options, double deflection) {
    file_ = options.out;
    every_ = options.saveEvery;
    productName_ = options.file;
    deflection_ = deflection;
    console_ = options.console;
  }
  const AssembledProduct& product() const { return product_; }

  void asking(const std::vector<BodyGroup>& groups, int effort) override {
    keep();
    if (effort > 0)
      notes_.note({GLISSADE_TEXT("searching motions of %1 {1|part|parts}, effort %2"), {groups.size(), effort}});
  }

  void stepFound(const AssemblyPlan& plan) override {
    for (; reported_ < plan.steps.size(); ++reported_) {
      const StepMotion& motion = plan.steps[reported_].only();
      notes_.note(
          {motion.with.empty() ? GLISSADE_TEXT("%1 of %2 {2|part|parts}: %3 removed (%4)")
                               : GLISSADE_TEXT("%1 of %2 {2|part|parts}: %3 removed as one (%4)"),
           {plan.removed(), plan.parts(), namesOf(motion.bodies(), product_, " + "), methodInWords(motion.method)}});
    }
    if (file_.empty()) return;
    unkept_ = plan;
    keep();
  }

  /// The motions of this plan are not reported.
  void skip(const AssemblyPlan& plan) {
    for (const AssemblyStep& step : plan.steps) reported_ += step.motions.size();
  }

 private:
  /// Writes the steps found since the last writing if enough time has passed.
  void keep() {
    constexpr double kWriting = 20.0;  // the pause is at least this many times the duration of a writing
    if (!unkept_ || secondsSince(kept_) < std::max(every_, kWriting * writing_)) return;
    unkept_->deflection = deflection_;
    kept_ = Clock::now();
    if (const Outcome saved = savePlan(*unkept_, productName_, file_); !saved)
      reportWarnings({saved.error()}, console_);
    writing_ = secondsSince(kept_);
    unkept_.reset();
  }

  StopToken stop_;
  ThreadTeam& team_;
  const AssembledProduct& product_;
  ProgressNotes notes_;
  std::size_t reported_ = 0;  ///< number of motions
  std::string file_;          ///< empty: no plan is written during the search
  Console console_;           ///< for warnings of the writing
  std::string productName_;
  double deflection_ = 0.0;
  std::optional<AssemblyPlan> unkept_;
  Clock::time_point kept_ = Clock::now();
  double every_ = 0.0;    ///< seconds
  double writing_ = 0.0;  ///< seconds that the last writing took
};

/// The texts between commas.
std::vector<std::string> listed(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, ',');) parts.push_back(part);
  return parts;
}

/// Reads "-z" or three numbers; nothing if the words are neither.
std::optional<Vector3> directionIn(const std::vector<std::string>& words) {
  if (words.size() == 1) return axisNamed(words[0]);
  if (words.size() != 3) return std::nullopt;
  Vector3 direction;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto number = toNumber(words[i]);
    if (!number) return std::nullopt;
    direction[static_cast<Eigen::Index>(i)] = *number;
  }
  return direction.norm() > 0.0 ? std::optional(direction) : std::nullopt;
}

Outcome addStepDemands(const SequenceOptions& options, SequenceDemands& demands) {
  constexpr double kMostPlaces = 1e6;
  for (const std::string& text : options.places) {
    auto words = listed(text);
    const auto place = words.size() < 2 ? std::nullopt : toNumber(words[0]);
    if (!place || *place < 1.0 || *place > kMostPlaces || *place != std::floor(*place)) {
      return Diagnostic{ErrorKind::Usage,
                        "",
                        "--place",
                        {GLISSADE_TEXT("is not a number from 1, a comma and a name: %1"), {text}},
                        GLISSADE_TEXT("Give 3,name.")};
    }
    demands.places.push_back({{words.begin() + 1, words.end()}, static_cast<std::size_t>(*place)});
  }
  for (const std::string& text : options.forbidden) {
    const auto words = listed(text);
    const auto direction = words.size() < 2 ? std::nullopt : directionIn({words.begin() + 1, words.end()});
    if (!direction) {
      return Diagnostic{ErrorKind::Usage,
                        "",
                        "--forbid",
                        {GLISSADE_TEXT("is not a name, a comma and a direction: %1"), {text}},
                        GLISSADE_TEXT("Give name,-z or name,0,0,-1.")};
    }
    demands.forbidden.push_back({words[0], *direction});
  }
  return Done{};
}

/// Adds the demands of the options to those of the scenario.
Result<SequenceDemands> demandsOf(const SequenceOptions& options, SequenceDemands demands) {
  for (const std::string& text : options.together) demands.together.push_back(listed(text));
  for (const std::string& text : options.before) {
    const auto pair = listed(text);
    if (pair.size() != 2) {
      return Diagnostic{ErrorKind::Usage,
                        "",
                        "--before",
                        {GLISSADE_TEXT("is not two names with a comma between them: %1"), {text}},
                        GLISSADE_TEXT("Give first,then.")};
    }
    demands.before.emplace_back(pair[0], pair[1]);
  }
  const Outcome steps = addStepDemands(options, demands);
  if (!steps) return steps.error();
  if (!options.gravity.empty()) {
    if (options.gravity.size() != 3 ||
        Vector3(options.gravity[0], options.gravity[1], options.gravity[2]).isZero(0.0)) {
      return Diagnostic{ErrorKind::Usage, "", "--gravity", GLISSADE_TEXT("is no direction"),
                        GLISSADE_TEXT("Give three numbers, as 0 0 -1.")};
    }
    demands.gravity = {options.gravity[0], options.gravity[1], options.gravity[2]};
  }
  if (!options.cost.empty()) demands.cost = options.cost;
  if (!options.joints.empty()) {
    const auto use = kJointUseNames.find(options.joints);
    if (!use) {
      return Diagnostic{ErrorKind::Usage,
                        "",
                        "--joints",
                        {GLISSADE_TEXT("is unknown: %1"), {options.joints}},
                        {GLISSADE_TEXT("Choose one of: %1."), {kJointUseNames.listed()}}};
    }
    demands.jointUse = *use;
  }
  return demands;
}

Diagnostic fitsAreOff(const std::string& file) {
  return {ErrorKind::MalformedInput, file, "/fits",
          GLISSADE_TEXT("are off, so that no part is removed that touches another one where it is assembled"),
          GLISSADE_TEXT("Run again with --fits on, or switch them on in the scenario.")};
}

/// Names of the staying bodies, from the options and from the product's attributes.
std::vector<std::string> stayingNames(const SequenceOptions& options, const SequenceDemands& demands) {
  std::vector<std::string> names = options.staying;
  names.insert(names.end(), demands.stay.begin(), demands.stay.end());
  return names;
}

/// The plan that is resumed, checked against the options.
Result<AssemblyPlan> resumedPlan(const SequenceOptions& options) {
  auto plan = readPlan(options.resume);
  if (!plan) return plan;
  const bool other = !options.strategy.empty() && plan->strategy != options.strategy;
  if (other || (options.seed && *options.seed != plan->seed) || !options.staying.empty() || options.deflection > 0.0) {
    return Diagnostic{ErrorKind::Usage, options.resume, "",
                      GLISSADE_TEXT("has a strategy, a seed, a base and a mesh tolerance of its own"),
                      GLISSADE_TEXT("Leave out --strategy, --seed, --stay and --deflection, or plan anew.")};
  }
  const bool demands = !options.together.empty() || !options.before.empty() || !options.gravity.empty() ||
                       !options.cost.empty() || !options.places.empty() || !options.forbidden.empty() ||
                       !options.joints.empty();
  if (demands && plan->demands != SequenceDemands()) {
    return Diagnostic{
        ErrorKind::Usage, options.resume, "", GLISSADE_TEXT("has constraints of its own"),
        GLISSADE_TEXT(
            "Leave out --together, --before, --place, --forbid, --gravity, --joints and --cost, or plan anew.")};
  }
  return plan;
}

/// Changes the error of a wrong cost so that it names the option, if the option gave the cost.
Diagnostic ofOptions(Diagnostic why, const SequenceOptions& options) {
  if (options.cost.empty() || why.location != Location("/sequence/cost")) return why;
  why.kind = ErrorKind::Usage;
  why.location = "--cost";
  return why;
}

/// The exit codes of `check` for the plan.
int exitCodeOf(const AssemblyPlan& plan, bool hasConditions, const MissingShapes& missing) {
  switch (plan.end) {
    case PlanEnd::Complete:
      if (bodiesApart(plan) < plan.removed()) return exitCode(ErrorKind::NoPath);
      if (hasConditions) return kExitUnderConditions;
      if (plan.removedWithoutProof() > 0) return kExitWithoutProof;
      return exitCodeWithout(missing);
    case PlanEnd::Stuck: return exitCode(ErrorKind::NoPath);
    case PlanEnd::TimeLimit: return exitCode(ErrorKind::LimitReached);
    case PlanEnd::Interrupted: break;
  }
  return exitCode(ErrorKind::Interrupted);
}

Outcome checkOptions(const SequenceOptions& options) {
  if (!options.strategy.empty() && makeSequenceStrategyRegistry().find(options.strategy) == nullptr) {
    return Diagnostic{ErrorKind::Usage,
                      "",
                      "--strategy",
                      {GLISSADE_TEXT("is unknown: %1"), {options.strategy}},
                      GLISSADE_TEXT("Choose greedy or best-first.")};
  }
  if (!(options.timeLimit >= 0.0)) {
    return Diagnostic{ErrorKind::Usage, "", "--time-limit", GLISSADE_TEXT("is below zero"),
                      GLISSADE_TEXT("Give seconds, 0 for none.")};
  }
  return Done{};
}

/// The plan to write if the time limit ends the search of fits. It can be resumed.
AssemblyPlan planWithout(const AssembledProduct& product, const SequenceRequest& request) {
  AssemblyPlan plan = request.resumed != nullptr ? *request.resumed : AssemblyPlan{};
  plan.strategy = request.strategy;
  plan.seed = request.seed;
  plan.demands = request.demands;
  plan.end = PlanEnd::TimeLimit;
  if (request.resumed != nullptr) return plan;
  for (std::size_t body = 0; body < product.bodies.size(); ++body) {
    plan.bodies.push_back(product.bodies[body].id);
    if (request.staying[body]) plan.staying.push_back(product.bodies[body].id);
  }
  return plan;
}

/// Writes and prints the plan, and returns the exit code.
int deliver(const AssemblyPlan& plan, const ProductFile& loaded, const SequenceOptions& options,
            const ProgressHost& host, double seconds, std::size_t plainOverlaps,
            const std::vector<Message>& conditions) {
  if (!loaded.product.fits.on && !plan.stuck.empty()) reportWarnings({fitsAreOff(options.file)}, options.console);
  if (!options.out.empty()) {
    if (const Outcome saved = savePlan(plan, options.file, options.out); !saved) {
      return reportError(saved.error(), options.console);
    }
  }
  if (options.console.json) {
    nlohmann::ordered_json report = planJson(plan, options.file);
    report["wall_s"] = seconds;
    report["surface_deviation_m"] = loaded.deviation;
    report["plain_overlaps"] = plainOverlaps;
    report["missing_shapes"] = missingShapesJson(loaded.missing);
    for (const Message& each : conditions) report["conditions"].push_back(toString(each));
    printJson(report);
  } else {
    printPlan(plan, host.product(), seconds, options.console);
    if (!loaded.missing.empty()) options.console.print(statementOf(loaded.missing));
    if (plainOverlaps > 0) options.console.print(check::plainOverlapsInWords(plainOverlaps));
    for (const Message& each : conditions) options.console.print({GLISSADE_TEXT("condition: %1"), {each}});
    if (!conditions.empty()) {
      options.console.print(GLISSADE_TEXT("Only the plan states this. State the conditions in the scenario."));
    }
  }
  return exitCodeOf(plan, !conditions.empty(), loaded.missing);
}

/// Most of a limited time is for fits; motions are searched in the rest, also where pairs are left.
std::optional<FitDeadlines> fitDeadlines(const StopToken& stop, const SequenceOptions& options) {
  constexpr double kContacts = 0.35;
  constexpr double kPairs = 0.6;
  if (options.timeLimit <= 0.0) return std::nullopt;
  return FitDeadlines{withTimeLimit(stop, kContacts * options.timeLimit),
                      withTimeLimit(stop, kPairs * options.timeLimit)};
}

}  // namespace

int runSequence(const SequenceOptions& options) {
  if (const Outcome sound = checkOptions(options); !sound) return reportError(sound.error(), options.console);
  const Interrupt interrupt;
  const auto begin = Clock::now();
  const StopToken stop = withTimeLimit(interrupt.token(), options.timeLimit);
  std::optional<AssemblyPlan> earlier;
  if (!options.resume.empty()) {
    auto read = resumedPlan(options);
    if (!read) return reportError(read.error(), options.console);
    earlier = std::move(*read);
  }
  const double deflection = earlier ? earlier->deflection : options.deflection;
  const PartChoice choice{options.open, earlier ? earlier->bodies : std::vector<BodyId>()};
  auto loaded = loadProduct(options.file, interrupt.token(), deflection, choice);
  if (!loaded) return reportError(loaded.error(), options.console);
  if (const Outcome left = leaveOut(options.without, *loaded); !left) return reportError(left.error(), options.console);
  AssembledProduct& product = loaded->product;
  options.fits.applyTo(product.fits);
  if (earlier) {
    if (const Outcome same = checkSameBodies(*earlier, product, options.resume); !same) {
      return reportError(same.error(), options.console);
    }
  }
  const bool hasDemands = earlier && earlier->demands != SequenceDemands();
  if (!hasDemands) loaded->demands.joints = loaded->joints;
  const auto demands = demandsOf(options, hasDemands ? earlier->demands : loaded->demands);
  if (!demands) return reportError(demands.error(), options.console);
  const auto staying = stayingBodies(product, earlier ? textsOf(earlier->staying) : stayingNames(options, *demands));
  if (!staying) {
    Diagnostic why = staying.error();
    why.location = "--stay";
    return reportError(why, options.console);
  }
  ThreadTeam team(options.lanes - 1);
  const std::uint64_t seed = earlier ? earlier->seed : options.seed.value_or(1);
  const ProgressNotes notes(begin, options.console);
  FitProgress progress(notes);
  const WorkWatch watch(stop, [&](double share) { progress.show(share); });
  ProductFinder finder(usersFitsCache(versionText()));
  const auto found =
      finder.findings(product, loaded->classes, *demands, team, watch, fitDeadlines(interrupt.token(), options));
  const bool outOfTime = !found && found.error().kind == ErrorKind::Interrupted && !interrupt.requested();
  if (!found && !outOfTime) return reportError(found.error(), options.console);
  reportWarnings(loaded->warnings, options.console);
  if (loaded->forbidsPlaces) reportWarnings({placesHoldForPathsOnly(options.file)}, options.console);
  std::optional<AssemblyPlan> reused;
  if (!options.reuse.empty()) {
    const auto read = readPlan(options.reuse);
    if (!read) return reportError(read.error(), options.console);
    reused = carriedTo(product, *read).plan;
  }
  ProgressHost host(stop, team, product, notes);
  if (earlier) host.skip(*earlier);
  const std::string usual = options.strategy.empty() ? kUsualStrategy : options.strategy;
  const std::string strategy = earlier ? earlier->strategy : usual;
  SequenceRequest request{*staying, strategy, seed, *demands, earlier ? &*earlier : nullptr};
  request.known = reused ? &*reused : nullptr;
  if (outOfTime) {
    reportWarnings({{ErrorKind::LimitReached, options.file, "--time-limit",
                     GLISSADE_TEXT("was reached while fits were searched"), GLISSADE_TEXT("Give more time.")}},
                   options.console);
  } else {
    request.joints = &found->joints;
    if (const std::size_t left = found->fits.notCompared(); left > 0) {
      reportWarnings(
          {{ErrorKind::LimitReached,
            options.file,
            "--time-limit",
            {GLISSADE_TEXT("leaves %1 {1|pair|pairs} of bodies that are not compared, and whose bodies may stay"),
             {left}},
            GLISSADE_TEXT("Give more time.")}},
          options.console);
    }
    reportWarnings(found->fits.warnings(), options.console);
    reportWarnings(warningsOf(findAlternatives(product.bodies, stop), product.bodies), options.console);
    if (!options.out.empty()) host.keepIn(options, deflection);
  }
  auto planned = outOfTime ? planWithout(product, request) : planSequence(product, found->fits, request, host);
  if (!planned) return reportError(ofOptions(planned.error(), options), options.console);
  AssemblyPlan& plan = *planned;
  const bool isShort = plan.end == PlanEnd::Stuck && found && found->fits.notCompared() > 0;
  if (isShort || (plan.end == PlanEnd::Interrupted && !interrupt.requested())) plan.end = PlanEnd::TimeLimit;
  plan.deflection = deflection;
  std::size_t plainOverlaps = 0;
  if (found) {
    const std::vector<Contact>& contacts = found->fits.contacts();
    plainOverlaps = static_cast<std::size_t>(
        std::count_if(contacts.begin(), contacts.end(), [](const Contact& each) { return each.isPlainOverlap; }));
  }
  const StatedUnits units = statedUnitsOf(plan, product, loaded->joints, stayingNames(options, *demands));
  return deliver(plan, *loaded, options, host, secondsSince(begin), plainOverlaps, conditionsOf(plan, product, units));
}

}  // namespace glissade::cli
