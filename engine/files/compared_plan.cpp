#include "engine/files/compared_plan.h"

#include <algorithm>
#include <numbers>

#include "engine/base/number_text.h"
#include "engine/base/quantity_text.h"
#include "engine/check/plan_verdict.h"
#include "engine/check/verdict_report.h"
#include "engine/files/judged_product.h"
#include "engine/sequence/plan_bodies.h"

namespace glissade {
namespace {

Message differenceOf(const ChangedPart& part) {
  if (part.reshaped > 0.0) return {GLISSADE_TEXT("another shape, up to %1 apart"), {Length{part.reshaped}}};
  const double degrees = part.turned * 180.0 / std::numbers::pi;
  constexpr double kLeastShown = 0.05;
  if (degrees < kLeastShown) return {GLISSADE_TEXT("moved by %1"), {Length{part.moved}}};
  return {GLISSADE_TEXT("moved by %1 and turned by %2 degrees"), {Length{part.moved}, shortText(degrees)}};
}

/// Reduces the allowances of a motion to what the later revision bears. False if none was larger.
bool reduceAllowances(const check::StepVerdict& verdict, StepMotion& motion) {
  bool reduced = false;
  for (const check::AppliedAllowance& applied : verdict.allowances) {
    for (Allowance& each : motion.allowances) {
      const bool isOfPair = each.body == applied.other && (each.moving.empty() || each.moving == applied.moving);
      if (!isOfPair || each.yields != applied.yields || each.allowance <= applied.most) continue;
      each.allowance = applied.most;
      reduced = true;
    }
  }
  std::erase_if(motion.allowances, [](const Allowance& each) { return each.allowance <= 0.0; });
  return reduced;
}

/// The verdict on the carried steps in the later revision. Allowances that it does not bear are reduced first.
check::PlanVerdict judgeCarried(CarriedPlan& carried, const ProductFile& now, const StopToken& stop) {
  const auto judge = [&] { return judgePlan(carried.plan, now.product, std::nullopt, {stop}, &now.demands); };
  check::PlanVerdict verdict = judge();
  bool reduced = false;
  for (const check::StepVerdict& each : verdict.steps) {
    if (each.valid()) continue;
    std::vector<StepMotion>& motions = carried.plan.steps[each.number - 1].motions;
    reduced = reduceAllowances(each, motions[each.motionNumber == 0 ? 0 : each.motionNumber - 1]) || reduced;
  }
  return reduced ? judge() : verdict;
}

}  // namespace

std::size_t ComparedPlan::holding() const {
  return static_cast<std::size_t>(
      std::count_if(steps.begin(), steps.end(), [](const auto& each) { return each.holds; }));
}

ComparedPlan comparePlan(const AssemblyPlan& plan, const AssembledProduct& before, ProductFile now,
                         const ProductChanges& changes, const StopToken& stop) {
  for (const auto& [earlier, later] : changes.renamed) now.product.bodies[later].id = before.bodies[earlier].id;
  const AssembledProduct& product = now.product;
  CarriedPlan carried = carriedTo(product, plan);
  const check::PlanVerdict verdict = judgeCarried(carried, now, stop);
  const check::Product judged = judgedProduct(product);
  ComparedPlan compared;
  std::vector<bool> hasStep(product.bodies.size(), false);
  for (const std::size_t body : product.indicesOf(carried.plan.staying)) hasStep[body] = true;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    ComparedStep step{check::stepNumber(i, plan.steps.size())};
    for (const BodyId& id : plan.steps[i].bodies()) {
      const auto body = before.find(id);
      step.bodies.push_back(body ? before.bodies[*body].shown() : id.text());
      if (!product.find(id)) step.gone.push_back(step.bodies.back());
    }
    const auto kept = std::find(carried.from.begin(), carried.from.end(), i);
    if (kept == carried.from.end()) {
      step.why = GLISSADE_TEXT("a part of it is gone");
    } else {
      const auto number = static_cast<std::size_t>(kept - carried.from.begin()) + 1;
      step.holds = verdict.isValid(number);
      step.why = check::whyInvalid(verdict, number, judged);
      for (const std::size_t body : bodiesOf(carried.plan.steps[number - 1], product)) hasStep[body] = true;
    }
    compared.steps.push_back(std::move(step));
  }
  std::reverse(compared.steps.begin(), compared.steps.end());
  for (std::size_t body = 0; body < hasStep.size(); ++body) {
    if (!hasStep[body]) compared.withoutStep.push_back(product.bodies[body].shown());
  }
  return compared;
}

std::vector<Message> inWords(const ProductChanges& changes, const AssembledProduct& before,
                             const AssembledProduct& now) {
  const auto nameBefore = [&](std::size_t body) { return before.bodies[body].shown(); };
  const auto nameNow = [&](std::size_t body) { return now.bodies[body].shown(); };
  std::vector<Message> lines;
  for (const std::size_t body : changes.came) lines.push_back({GLISSADE_TEXT("came: %1"), {nameNow(body)}});
  for (const std::size_t body : changes.went) lines.push_back({GLISSADE_TEXT("went: %1"), {nameBefore(body)}});
  for (const auto& [earlier, later] : changes.renamed)
    lines.push_back({GLISSADE_TEXT("renamed: %1 is %2"), {nameBefore(earlier), nameNow(later)}});
  for (const ChangedPart& part : changes.changed)
    lines.push_back({GLISSADE_TEXT("changed: %1, %2"), {nameNow(part.now), differenceOf(part)}});
  lines.push_back(
      {GLISSADE_TEXT("parts: %1 unchanged, %2 changed, %3 renamed, %4 came, %5 went"),
       {changes.unchanged, changes.changed.size(), changes.renamed.size(), changes.came.size(), changes.went.size()}});
  return lines;
}

std::vector<Message> inWords(const ComparedPlan& plan) {
  std::vector<Message> lines;
  const auto listed = [](const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : " + ") + name;
    return list;
  };
  for (const ComparedStep& step : plan.steps) {
    const std::string names = listed(step.bodies);
    if (step.holds && !step.gone.empty())
      lines.push_back({GLISSADE_TEXT("step %1 (%2) holds without %3"), {step.number, names, listed(step.gone)}});
    if (step.holds) continue;
    lines.push_back({GLISSADE_TEXT("step %1 (%2) does not hold: %3"), {step.number, names, step.why}});
  }
  for (const std::string& name : plan.withoutStep) lines.push_back({GLISSADE_TEXT("no step: %1"), {name}});
  lines.push_back({GLISSADE_TEXT("%1 of %2 {2|step holds|steps hold}, %3 {3|part has|parts have} no step"),
                   {plan.holding(), plan.steps.size(), plan.withoutStep.size()}});
  return lines;
}

}  // namespace glissade
