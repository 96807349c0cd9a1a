#include "app/cli/commands.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/interrupt.h"
#include "engine/base/number_text.h"
#include "engine/base/quantity_text.h"
#include "engine/check/plain_overlaps.h"
#include "engine/import/missing_shapes_json.h"
#include "engine/product/alternatives.h"
#include "engine/product/joint_edits.h"
#include "engine/product/joint_finder.h"
#include "engine/scenario/plan_file.h"
#include "engine/scenario/product_file.h"
#include "engine/sequence/fasteners.h"
#include "engine/sequence/sequence_run.h"
#include "engine/sequence/step_motion.h"
#include "engine/sequence/subassembly_lines.h"
#include "engine/study/plan_tasks.h"
#include "engine/study/plan_words.h"

namespace glissade::cli {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// Begins a line on standard error about the progress of a run that began at this time.
std::ostream& progressLine(Clock::time_point begin) {
  return std::cerr << "glissade-cli: " << std::fixed << std::setprecision(1) << secondsSince(begin)
                   << " s: " << std::defaultfloat;
}

/// Writes every few seconds the share of the compared pairs of bodies.
class FitProgress {
 public:
  explicit FitProgress(Clock::time_point begin) : begin_(begin), shown_(Clock::now()) {}

  void show(double share) {
    constexpr double kEvery = 5.0;
    if (secondsSince(shown_) < kEvery) return;
    shown_ = Clock::now();
    progressLine(begin_) << "comparing pairs of bodies, " << std::lround(100.0 * share) << " %\n";
  }

 private:
  Clock::time_point begin_;
  Clock::time_point shown_;
};

/// Prints a line on standard error for each step that is found and for each search.
class ProgressHost final : public SequenceHost {
 public:
  ProgressHost(StopToken stop, ThreadTeam& team, const AssembledProduct& product, Clock::time_point begin)
      : stop_(std::move(stop)), team_(team), product_(product), begin_(begin) {}

  const StopToken& stopToken() const override { return stop_; }
  ThreadTeam& team() override { return team_; }

  /// From now on the plan is written every few seconds. `deflection`: as AssemblyPlan::deflection.
  void keepIn(const SequenceOptions& options, double deflection) {
    file_ = options.out;
    every_ = options.saveEvery;
    productName_ = options.file;
    deflection_ = deflection;
  }
  const AssembledProduct& product() const { return product_; }

  void asking(std::size_t bodies, int effort) override {
    keep();
    if (effort > 0) progressLine(begin_) << "searching motions of " << bodies << " parts, effort " << effort << "\n";
  }

  void stepFound(const AssemblyPlan& plan) override {
    for (; reported_ < plan.steps.size(); ++reported_) {
      const AssemblyStep& step = plan.steps[reported_];
      progressLine(begin_) << plan.removed() << " of " << plan.parts() << " parts: " << namesOf(step)
                           << (step.with.empty() ? " leaves (" : " leave as one (") << step.method << ")\n";
    }
    if (file_.empty()) return;
    unkept_ = plan;
    keep();
  }

  const std::string& nameOf(const std::string& id) const { return product_.bodies[*product_.indexOf(id)].shown(); }
  std::string namesOf(const AssemblyStep& step) const {
    std::string names = nameOf(step.body);
    for (const std::string& id : step.with) names += " + " + nameOf(id);
    return names;
  }
  void skip(std::size_t steps) { reported_ = steps; }

 private:
  /// Writes the steps found since the last writing if enough time has passed.
  void keep() {
    constexpr double kWriting = 20.0;  // the pause is at least this many times the duration of a writing
    if (!unkept_ || secondsSince(kept_) < std::max(every_, kWriting * writing_)) return;
    unkept_->deflection = deflection_;
    kept_ = Clock::now();
    if (const Outcome saved = savePlan(*unkept_, productName_, file_); !saved) reportWarnings({saved.error()});
    writing_ = secondsSince(kept_);
    unkept_.reset();
  }

  StopToken stop_;
  ThreadTeam& team_;
  const AssembledProduct& product_;
  Clock::time_point begin_;
  std::size_t reported_ = 0;
  std::string file_;  ///< empty: no plan is written during the search
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
      return Diagnostic{ErrorKind::Usage, "", "--place", "is not a number from 1, a comma and a name: " + text,
                        "Give 3,name."};
    }
    demands.places.push_back({{words.begin() + 1, words.end()}, static_cast<std::size_t>(*place)});
  }
  for (const std::string& text : options.forbidden) {
    const auto words = listed(text);
    const auto direction = words.size() < 2 ? std::nullopt : directionIn({words.begin() + 1, words.end()});
    if (!direction) {
      return Diagnostic{ErrorKind::Usage, "", "--forbid", "is not a name, a comma and a direction: " + text,
                        "Give name,-z or name,0,0,-1."};
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
      return Diagnostic{ErrorKind::Usage, "", "--before", "is not two names with a comma between them: " + text,
                        "Give first,then."};
    }
    demands.before.emplace_back(pair[0], pair[1]);
  }
  const Outcome steps = addStepDemands(options, demands);
  if (!steps) return steps.error();
  if (!options.gravity.empty()) {
    if (options.gravity.size() != 3 ||
        Vector3(options.gravity[0], options.gravity[1], options.gravity[2]).isZero(0.0)) {
      return Diagnostic{ErrorKind::Usage, "", "--gravity", "is no direction", "Give three numbers, as 0 0 -1."};
    }
    demands.gravity = {options.gravity[0], options.gravity[1], options.gravity[2]};
  }
  if (!options.cost.empty()) demands.cost = options.cost;
  if (!options.joints.empty()) {
    const auto use = kJointUseNames.find(options.joints);
    if (!use) {
      return Diagnostic{ErrorKind::Usage, "", "--joints", "is unknown: " + options.joints,
                        "Choose one of: " + kJointUseNames.listed() + "."};
    }
    demands.jointUse = *use;
  }
  return demands;
}

Diagnostic fitsAreOff(const std::string& file) {
  return {ErrorKind::MalformedInput, file, "/fits",
          "are off, so that no part leaves that touches another one where it is assembled",
          "Run again with --fits on, or switch them on in the scenario."};
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
                      "has a strategy, a seed, staying bodies and a deflection of its own",
                      "Leave out --strategy, --seed, --stay and --deflection, or plan anew."};
  }
  const bool demands = !options.together.empty() || !options.before.empty() || !options.gravity.empty() ||
                       !options.cost.empty() || !options.places.empty() || !options.forbidden.empty() ||
                       !options.joints.empty();
  if (demands && plan->demands != SequenceDemands()) {
    return Diagnostic{
        ErrorKind::Usage, options.resume, "", "has demands of its own",
        "Leave out --together, --before, --place, --forbid, --gravity, --joints and --cost, or plan anew."};
  }
  return plan;
}

/// Changes the error of a wrong cost so that it names the option, if the option gave the cost.
Diagnostic ofOptions(Diagnostic why, const SequenceOptions& options) {
  if (options.cost.empty() || why.location != "/sequence/cost") return why;
  why.kind = ErrorKind::Usage;
  why.location = "--cost";
  return why;
}

/// ", every motion certified", with the number of flexible parts without a proof; empty if no part leaves.
std::string certifiedText(const AssemblyPlan& plan) {
  if (plan.removed() == 0) return "";
  const std::size_t open = plan.removedWithoutProof();
  if (open == 0) return ", every motion certified";
  return ", every motion certified but those of " + std::to_string(open) + " flexible parts";
}

/// Prints the steps with the numbers of the order of assembly, as in documents. `group`: number of the step that adds
/// the group of these steps.
void printSteps(const std::vector<AssemblyStep>& steps, const std::string& group, const std::string& before,
                const ProgressHost& host) {
  const PlanWords words(Language::English, inMillimetres);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const AssemblyStep& step = steps[i];
    std::cout << before << std::setw(4) << stepNumber(steps.size() - 1 - i, group) << "  " << host.namesOf(step);
    if (step.fastener != FastenerKind::None) std::cout << " (" << kFastenerNames.of(step.fastener) << ")";
    std::cout << ": " << step.method;
    if (!step.certified) std::cout << ", not certified";
    if (!step.proof.nearest.empty()) {
      std::cout << ", clearance " << inMillimetres(step.proof.minClearance) << " to '"
                << host.nameOf(step.proof.nearest) << "'";
    }
    std::cout << "\n";
    for (const std::string& text : words.joints(step, host.product(), PlanOrder::Removal)) {
      std::cout << before << "      " << text << "\n";
    }
    if (step.tool.kind != ToolKind::None) {
      std::cout << before << "      tool: " << words.tool(step, host.product()) << "\n";
    }
    for (const std::string& text : words.violations(step, host.product())) {
      std::cout << before << "      forced, although: " << text << "\n";
    }
    for (const std::string& id : step.falling) std::cout << before << "      to be held: " << host.nameOf(id) << "\n";
    for (const StepAllowance& allowance : step.allowances) {
      std::cout << before << "      allowance: " << allowance.text << "\n";
    }
  }
}

void printStuck(const std::vector<StuckBody>& all, const std::string& before, const ProgressHost& host) {
  for (const StuckBody& stuck : all) {
    std::cout << before << "stuck: " << host.nameOf(stuck.body);
    const char* separator = ", blocked by ";
    for (const std::string& other : stuck.blockedBy) {
      std::cout << separator << host.nameOf(other);
      separator = ", ";
    }
    std::cout << (stuck.reason.empty() ? "" : ": ") << stuck.reason << "\n";
  }
}

/// Prints the lines of groups. `before` indents them: "      " at first, more for groups in groups.
void printLines(const std::vector<SubassemblyLine>& lines, std::size_t steps, const std::string& group,
                const std::string& before, const ProgressHost& host) {
  for (const SubassemblyLine& line : lines) {
    const std::string number = stepNumber(steps - line.step, group);
    std::cout << before << "the group of step " << number << " is taken apart off";
    for (const std::string& id : line.staying) std::cout << " " << host.nameOf(id);
    std::cout << ":\n";
    printSteps(line.steps, number, before, host);
    printStuck(line.stuck, before, host);
    printLines(line.lines, line.steps.size(), number, before + "  ", host);
  }
}

/// The number of screws in bodies that have no hole for them in the file.
std::size_t screwHoles(const std::vector<AssemblyStep>& steps, const std::vector<SubassemblyLine>& lines) {
  std::size_t holes = 0;
  for (const AssemblyStep& step : steps) {
    holes += static_cast<std::size_t>(
        std::count_if(step.allowances.begin(), step.allowances.end(),
                      [](const StepAllowance& each) { return each.hollow && each.kind == ContactKind::Thread; }));
  }
  for (const SubassemblyLine& line : lines) holes += screwHoles(line.steps, line.lines);
  return holes;
}

void printPlan(const AssemblyPlan& plan, const ProgressHost& host, double seconds) {
  if (!plan.staying.empty()) {
    const PlanWords words(Language::English, inMillimetres);
    std::cout << "base: " << words.base(plan, host.product()) << "\n";
  }
  printSteps(plan.steps, "", "", host);
  printLines(plan.lines, plan.steps.size(), "", "  ", host);
  printStuck(plan.stuck, "", host);
  const std::size_t apart = bodiesApart(plan);
  if (apart < plan.removed()) {
    std::cout << plan.removed() - apart << " of the parts that leave do so in groups that are not taken apart\n";
  }
  std::cout << plan.removed() << " of " << plan.parts() << " parts leave in " << plan.steps.size() << " steps"
            << certifiedText(plan) << ", computed in " << seconds << " s\n";
  if (const std::size_t holes = screwHoles(plan.steps, plan.lines); holes > 0) {
    std::cout << "screws in bodies without a hole in the file, each of which makes its own: " << holes << "\n";
  }
}

int exitCodeOf(const AssemblyPlan& plan) {
  switch (plan.end) {
    case PlanEnd::Complete:
      if (bodiesApart(plan) < plan.removed()) return exitCode(ErrorKind::NoPath);
      return plan.removedWithoutProof() == 0 ? 0 : kExitWithoutProof;
    case PlanEnd::Stuck: return exitCode(ErrorKind::NoPath);
    case PlanEnd::TimeLimit: return exitCode(ErrorKind::LimitReached);
    case PlanEnd::Interrupted: break;
  }
  return exitCode(ErrorKind::Interrupted);
}

Outcome checkOptions(const SequenceOptions& options) {
  if (!options.strategy.empty() && makeSequenceStrategyRegistry().find(options.strategy) == nullptr) {
    return Diagnostic{ErrorKind::Usage, "", "--strategy", "is unknown: " + options.strategy,
                      "Choose greedy or best-first."};
  }
  if (!(options.timeLimit >= 0.0)) {
    return Diagnostic{ErrorKind::Usage, "", "--time-limit", "is below zero", "Give seconds, 0 for none."};
  }
  return Done{};
}

/// The joints that the demands use; none after a stop, because a person's word may be about a joint that was not found.
Result<Joints> jointsOf(const ProductFile& loaded, const SequenceDemands& demands, const StopToken& stop) {
  if (demands.jointUse == JointUse::Off) return Joints();
  const Joints found = findJoints(loaded.product, stop, loaded.classes);
  if (stop.stopRequested()) return Joints();
  return applied(found, demands.joints, loaded.product);
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
            const ProgressHost& host, double seconds, std::size_t plainOverlaps) {
  if (!loaded.product.fits.on && !plan.stuck.empty()) reportWarnings({fitsAreOff(options.file)});
  if (!options.out.empty()) {
    if (const Outcome saved = savePlan(plan, options.file, options.out); !saved) {
      return reportError(saved.error(), options.format);
    }
  }
  if (options.format == Format::Json) {
    nlohmann::ordered_json report = planJson(plan, options.file);
    report["wall_s"] = seconds;
    report["surface_deviation_m"] = loaded.deviation;
    report["plain_overlaps"] = plainOverlaps;
    report["missing_shapes"] = missingShapesJson(loaded.missing);
    printJson(report);
  } else {
    printPlan(plan, host, seconds);
    if (!loaded.missing.empty()) std::cout << statementOf(loaded.missing) << "\n";
    if (plainOverlaps > 0) std::cout << check::plainOverlapsInWords(plainOverlaps) << "\n";
  }
  return exitCodeOf(plan);
}

}  // namespace

int runSequence(const SequenceOptions& options) {
  if (const Outcome sound = checkOptions(options); !sound) return reportError(sound.error(), options.format);
  const Interrupt interrupt;
  const auto begin = Clock::now();
  const StopToken stop = withTimeLimit(interrupt.token(), options.timeLimit);
  std::optional<AssemblyPlan> earlier;
  if (!options.resume.empty()) {
    auto read = resumedPlan(options);
    if (!read) return reportError(read.error(), options.format);
    earlier = std::move(*read);
  }
  const double deflection = earlier ? earlier->deflection : options.deflection;
  const PartChoice choice{options.open, earlier ? earlier->bodies : std::vector<std::string>()};
  auto loaded = loadProduct(options.file, interrupt.token(), deflection, choice);
  if (!loaded) return reportError(loaded.error(), options.format);
  if (const Outcome left = leaveOut(options.without, *loaded); !left) return reportError(left.error(), options.format);
  AssembledProduct& product = loaded->product;
  product.fits = withOptions(product.fits, options.fits);
  if (earlier) {
    std::vector<std::string> ids;
    for (const RigidBody& body : product.bodies) ids.push_back(body.id);
    if (const Outcome same = checkSameBodies(*earlier, ids, options.resume); !same) {
      return reportError(same.error(), options.format);
    }
  }
  const bool hasDemands = earlier && earlier->demands != SequenceDemands();
  if (!hasDemands) loaded->demands.joints = loaded->joints;
  const auto demands = demandsOf(options, hasDemands ? earlier->demands : loaded->demands);
  if (!demands) return reportError(demands.error(), options.format);
  const auto staying = stayingBodies(product, earlier ? earlier->staying : stayingNames(options, *demands));
  if (!staying) {
    Diagnostic why = staying.error();
    why.location = "--stay";
    return reportError(why, options.format);
  }
  ThreadTeam team(options.lanes - 1);
  const std::uint64_t seed = earlier ? earlier->seed : options.seed.value_or(1);
  const auto joints = jointsOf(*loaded, *demands, stop);
  if (!joints) return reportError(joints.error(), options.format);
  product.snaps = bendsOf(countingJoints(*joints, demands->jointUse), product);
  FitProgress progress(begin);
  const auto fits = ProductFits::find(product, team, {stop, [&](double share) { progress.show(share); }});
  const bool outOfTime = !fits && fits.error().kind == ErrorKind::Interrupted && !interrupt.requested();
  if (!fits && !outOfTime) return reportError(fits.error(), options.format);
  reportWarnings(loaded->warnings);
  if (loaded->forbidsPlaces) reportWarnings({placesHoldForPathsOnly(options.file)});
  ProgressHost host(stop, team, product, begin);
  if (earlier) host.skip(earlier->steps.size());
  const std::string usual = options.strategy.empty() ? kUsualStrategy : options.strategy;
  const std::string strategy = earlier ? earlier->strategy : usual;
  SequenceRequest request{*staying, strategy, seed, *demands, earlier ? &*earlier : nullptr};
  request.joints = &*joints;
  if (outOfTime) {
    reportWarnings({{ErrorKind::LimitReached, options.file, "--time-limit", "was reached while fits were searched",
                     "Give more time."}});
  } else {
    reportWarnings(fits->warnings());
    reportWarnings(warningsOf(findAlternatives(product.bodies, stop), product.bodies));
    if (!options.out.empty()) host.keepIn(options, deflection);
  }
  auto planned = outOfTime ? planWithout(product, request) : planSequence(product, *fits, request, host);
  if (!planned) return reportError(ofOptions(planned.error(), options), options.format);
  AssemblyPlan& plan = *planned;
  if (plan.end == PlanEnd::Interrupted && !interrupt.requested()) plan.end = PlanEnd::TimeLimit;
  plan.deflection = deflection;
  std::size_t plainOverlaps = 0;
  if (fits) {
    const std::vector<Contact>& contacts = fits->contacts();
    plainOverlaps = static_cast<std::size_t>(
        std::count_if(contacts.begin(), contacts.end(), [](const Contact& each) { return each.isPlainOverlap; }));
  }
  return deliver(plan, *loaded, options, host, secondsSince(begin), plainOverlaps);
}

}  // namespace glissade::cli
