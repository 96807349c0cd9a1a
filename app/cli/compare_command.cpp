#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "engine/base/number_text.h"
#include "engine/base/quantity_text.h"
#include "engine/check/verdict_report.h"
#include "engine/documents/plan_tasks.h"
#include "engine/files/judged_product.h"
#include "engine/files/plan_file.h"
#include "engine/files/product_file.h"
#include "engine/sequence/product_changes.h"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Two revisions of a product, and the differences.
struct Revisions {
  ProductFile before;
  ProductFile now;
  ProductChanges changes{};

  const std::string& nameBefore(std::size_t body) const { return before.product.bodies[body].shown(); }
  const std::string& nameNow(std::size_t body) const { return now.product.bodies[body].shown(); }
};

/// A step of the earlier plan in the later revision.
struct ComparedStep {
  std::string number;  ///< number in the order of assembly, in the earlier plan
  std::vector<std::string> bodies{};
  bool holds = false;
  Message why{};  ///< the reason why it does not hold
};

/// The earlier plan in the later revision.
struct ComparedPlan {
  std::vector<ComparedStep> steps{};
  std::vector<std::string> withoutStep{};  ///< names of bodies of the later revision

  std::size_t holding() const {
    return static_cast<std::size_t>(
        std::count_if(steps.begin(), steps.end(), [](const auto& each) { return each.holds; }));
  }
  bool holds() const { return holding() == steps.size() && withoutStep.empty(); }
};

Message differenceOf(const ChangedPart& part) {
  if (part.reshaped > 0.0) return {GLISSADE_TEXT("another shape, up to %1 apart"), {Length{part.reshaped}}};
  const double degrees = part.turned * 180.0 / std::numbers::pi;
  constexpr double kLeastShown = 1e-3;
  if (degrees < kLeastShown) return {GLISSADE_TEXT("moved by %1"), {Length{part.moved}}};
  return {GLISSADE_TEXT("moved by %1 and turned by %2 degrees"), {Length{part.moved}, rounded(degrees)}};
}

void printChanges(const Revisions& both, const Console& console) {
  const ProductChanges& changes = both.changes;
  for (const std::size_t body : changes.came) console.print({GLISSADE_TEXT("came: %1"), {both.nameNow(body)}});
  for (const std::size_t body : changes.went) console.print({GLISSADE_TEXT("went: %1"), {both.nameBefore(body)}});
  for (const auto& [before, now] : changes.renamed)
    console.print({GLISSADE_TEXT("renamed: %1 is %2"), {both.nameBefore(before), both.nameNow(now)}});
  for (const ChangedPart& part : changes.changed)
    console.print({GLISSADE_TEXT("changed: %1, %2"), {both.nameNow(part.now), differenceOf(part)}});
  console.print(
      {GLISSADE_TEXT("parts: %1 unchanged, %2 changed, %3 renamed, %4 came, %5 went"),
       {changes.unchanged, changes.changed.size(), changes.renamed.size(), changes.came.size(), changes.went.size()}});
}

void printPlan(const ComparedPlan& plan, const Console& console) {
  for (const ComparedStep& step : plan.steps) {
    if (step.holds) continue;
    std::string names;
    for (const std::string& name : step.bodies) names += (names.empty() ? "" : " + ") + name;
    console.print({GLISSADE_TEXT("step %1 (%2) does not hold: %3"), {step.number, names, step.why}});
  }
  for (const std::string& name : plan.withoutStep) console.print({GLISSADE_TEXT("no step: %1"), {name}});
  console.print({GLISSADE_TEXT("%1 of %2 {2|step holds|steps hold}, %3 {3|part has|parts have} no step"),
                 {plan.holding(), plan.steps.size(), plan.withoutStep.size()}});
  if (!plan.holds()) {
    console.print(
        GLISSADE_TEXT("Plan again with 'glissade-cli sequence NEW --reuse PLAN --out FILE': motions of steps "
                      "that hold are taken over."));
  }
}

Json toJson(const Revisions& both, const ComparedPlan* plan) {
  const ProductChanges& changes = both.changes;
  Json json{{"unchanged", changes.unchanged},
            {"came", Json::array()},
            {"went", Json::array()},
            {"renamed", Json::array()},
            {"changed", Json::array()}};
  for (const std::size_t body : changes.came) json["came"].push_back(both.now.product.bodies[body].id);
  for (const std::size_t body : changes.went) json["went"].push_back(both.before.product.bodies[body].id);
  for (const auto& [before, now] : changes.renamed) {
    json["renamed"].push_back(
        {{"before", both.before.product.bodies[before].id}, {"now", both.now.product.bodies[now].id}});
  }
  for (const ChangedPart& part : changes.changed) {
    json["changed"].push_back({{"body", both.now.product.bodies[part.now].id},
                               {"reshaped_m", part.reshaped},
                               {"moved_m", part.moved},
                               {"turned_rad", part.turned}});
  }
  if (plan == nullptr) return json;
  json["steps"] = Json::array();
  for (const ComparedStep& step : plan->steps) {
    json["steps"].push_back({{"number", step.number}, {"bodies", step.bodies}, {"holds", step.holds}});
    if (!step.holds) json["steps"].back()["reason"] = toString(step.why);
  }
  json["without_step"] = plan->withoutStep;
  return json;
}

/// Reduces the allowances of a step to what the later revision bears. False if none was larger.
bool reduceAllowances(const check::StepVerdict& verdict, AssemblyStep& step) {
  bool reduced = false;
  for (const check::AppliedAllowance& applied : verdict.allowances) {
    for (Allowance& each : step.allowances) {
      const bool isOfPair = each.body == applied.other && (each.moving.empty() || each.moving == applied.moving);
      if (!isOfPair || each.yields != applied.yields || each.allowance <= applied.most) continue;
      each.allowance = applied.most;
      reduced = true;
    }
  }
  std::erase_if(step.allowances, [](const Allowance& each) { return each.allowance <= 0.0; });
  return reduced;
}

/// The verdict on the carried steps in the later revision. Allowances that it does not bear are reduced first.
check::PlanVerdict judgeCarried(CarriedPlan& carried, const ProductFile& now, const StopToken& stop) {
  const auto judge = [&] { return judgePlan(carried.plan, now.product, std::nullopt, {stop}, &now.demands); };
  check::PlanVerdict verdict = judge();
  bool reduced = false;
  for (std::size_t i = 0; i < verdict.steps.size(); ++i) {
    if (!verdict.steps[i].valid()) reduced = reduceAllowances(verdict.steps[i], carried.plan.steps[i]) || reduced;
  }
  return reduced ? judge() : verdict;
}

/// The steps of the plan, in the order of assembly, judged in the later revision.
ComparedPlan comparePlan(const AssemblyPlan& plan, const Revisions& both, const StopToken& stop) {
  const AssembledProduct& product = both.now.product;
  CarriedPlan carried = carriedTo(product, plan);
  const check::PlanVerdict verdict = judgeCarried(carried, both.now, stop);
  const check::Product judged = judgedProduct(product);
  ComparedPlan compared;
  std::vector<bool> hasStep(product.bodies.size(), false);
  for (const std::string& id : carried.plan.staying) hasStep[*product.indexOf(id)] = true;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    ComparedStep step{stepNumber(plan.steps.size() - 1 - i, "")};
    for (const std::string& id : plan.steps[i].bodies()) {
      const auto body = both.before.product.indexOf(id);
      step.bodies.push_back(body ? both.nameBefore(*body) : id);
    }
    const auto kept = std::find(carried.from.begin(), carried.from.end(), i);
    if (kept == carried.from.end()) {
      step.why = GLISSADE_TEXT("a part of it is gone");
    } else {
      const auto& found = verdict.steps[static_cast<std::size_t>(kept - carried.from.begin())];
      step.holds = found.valid();
      step.why = check::whyInvalid(found, judged);
      for (const std::string& id : plan.steps[i].bodies()) hasStep[*product.indexOf(id)] = true;
    }
    compared.steps.push_back(std::move(step));
  }
  std::reverse(compared.steps.begin(), compared.steps.end());
  for (std::size_t body = 0; body < hasStep.size(); ++body) {
    if (!hasStep[body]) compared.withoutStep.push_back(both.nameNow(body));
  }
  return compared;
}

}  // namespace

int runCompare(const CompareOptions& options) {
  const Interrupt interrupt;
  const StopToken stop = interrupt.token();
  std::optional<AssemblyPlan> plan;
  if (!options.plan.empty()) {
    auto read = readPlan(options.plan);
    if (!read) return reportError(read.error(), options.console);
    plan = std::move(*read);
  }
  const double deflection = plan ? plan->deflection : 0.0;
  const PartChoice choice{{}, plan ? plan->bodies : std::vector<std::string>()};
  auto before = loadProduct(options.before, stop, deflection, choice);
  if (!before) return reportError(before.error(), options.console);
  auto now = loadProduct(options.now, stop, deflection, choice);
  if (!now) return reportError(now.error(), options.console);
  if (plan) {
    std::vector<std::string> ids;
    for (const RigidBody& body : before->product.bodies) ids.push_back(body.id);
    if (const Outcome same = checkSameBodies(*plan, ids, options.plan); !same)
      return reportError(same.error(), options.console);
  }
  reportWarnings(now->warnings, options.console);
  Revisions both{std::move(*before), std::move(*now)};
  both.changes = changesBetween(both.before.product, both.now.product, stop);
  std::optional<ComparedPlan> compared;
  if (plan) compared = comparePlan(*plan, both, stop);
  if (interrupt.requested()) return exitCode(ErrorKind::Interrupted);
  if (options.console.json) {
    printJson(toJson(both, compared ? &*compared : nullptr));
  } else {
    printChanges(both, options.console);
    if (compared) printPlan(*compared, options.console);
  }
  const bool same = compared ? compared->holds() : both.changes.none();
  return same ? 0 : exitCode(ErrorKind::NoPath);
}

}  // namespace glissade::cli
