#include "engine/check/plan_verdict.h"

#include <algorithm>
#include <functional>
#include <mutex>
#include <set>

#include "engine/base/thread_team.h"
#include "engine/check/path_verdict.h"
#include "engine/check/plan_units.h"
#include "engine/check/step_judge.h"

namespace glissade::check {
namespace {

/// Limit of the nesting of groups.
constexpr std::size_t kMostDepth = 32;

/// Sum of the two largest deflections.
double largestTwo(const Product& product) {
  std::vector<double> values(2, 0.0);
  for (const Body& body : product.bodies) values.push_back(deflectionOf(body));
  std::partial_sort(values.begin(), values.begin() + 2, values.end(), std::greater<>());
  return values[0] + values[1];
}

/// A list of steps with its verdict.
struct JudgedList {
  std::vector<NumberedStep> steps;
  LineVerdict verdict;
};

Present presentOnly(const std::vector<BodyId>& ids, const Product& product) {
  Present there(product.bodies.size(), false);
  for (std::size_t body = 0; body < there.size(); ++body) {
    there[body] = std::find(ids.begin(), ids.end(), product.bodies[body].id) != ids.end();
  }
  return there;
}

std::size_t stepsIn(const std::vector<Step>& motions) { return motions.empty() ? 0 : motions.back().number; }

/// Claims of a line that contradict the step by which its group has left.
std::vector<Message> wrongLine(const Line& line, const std::vector<Step>& above) {
  const auto step =
      std::find_if(above.begin(), above.end(), [&](const Step& each) { return each.number == line.step; });
  if (step == above.end())
    return {{GLISSADE_TEXT("it states \"step\": %1, and there are %2"), {line.step, stepsIn(above)}}};
  const auto& group = step->bodies;
  std::vector<Message> wrong;
  if (std::set<BodyId>(group.begin(), group.end()) != std::set<BodyId>(line.bodies.begin(), line.bodies.end()) ||
      group.size() != line.bodies.size()) {
    wrong.emplace_back(GLISSADE_TEXT("its bodies are not those of its step"));
  }
  for (const BodyId& id : line.staying) {
    if (std::find(group.begin(), group.end(), id) != group.end()) continue;
    wrong.push_back({GLISSADE_TEXT("'%1' is fixed as base and is not in the group"), {id.text()}});
  }
  return wrong;
}

/// Adds the lines of these steps, and those below them.
void addLines(const std::vector<Line>& lines, const std::vector<Step>& above, const LineVerdict& parent,
              const Product& product, std::vector<JudgedList>& lists) {
  std::set<std::size_t> known;
  for (const Line& line : lines) {
    std::vector<std::size_t> numbers = parent.line;
    numbers.push_back(line.step);
    JudgedList list{numberedSteps(product, {line.steps, line.staying, presentOnly(line.bodies, product)}),
                    {numbers, {}, wrongLine(line, above), stepNumber(line.step - 1, stepsIn(above), parent.group)}};
    if (!known.insert(line.step).second) list.verdict.refusals.emplace_back(GLISSADE_TEXT("its step has another line"));
    const LineVerdict own{numbers, {}, {}, list.verdict.group};
    lists.push_back(std::move(list));
    if (numbers.size() < kMostDepth) addLines(line.lines, line.steps, own, product, lists);
  }
}

/// A person's demands on places, motions and groups of steps concern the steps of the plan, and not those of lines.
Demands ofLines(Demands demands) {
  demands.places.clear();
  demands.motions.clear();
  demands.together.clear();
  return demands;
}

void judgeDemands(const NumberedStep& step, const Demands& demands, const Product& product, bool isLine,
                  StepVerdict& result) {
  if (step.group.empty()) return;
  const BrokenDemands broken = brokenDemands(*step.step, step.group, step.there, step.step->number, product,
                                             isLine ? ofLines(demands) : demands);
  if (result.againstDemand.empty()) result.againstDemand = broken.refused;
  result.conditions.insert(result.conditions.end(), broken.givenUp.begin(), broken.givenUp.end());
}

/// The product with the bends that only the plan states.
Product withBends(Product product, const Plan& plan) {
  for (SnapWord word : plan.snaps) {
    word.byPlan = true;
    if (product.fits.snapOf(word.hook, word.edge) == nullptr) product.fits.snaps.push_back(word);
  }
  return product;
}

}  // namespace

std::string stepNumber(std::size_t index, std::size_t steps, const std::string& group) {
  return (group.empty() ? "" : group + ".") + std::to_string(steps - index);
}

std::size_t stepsIn(const std::vector<StepVerdict>& motions) { return motions.empty() ? 0 : motions.back().number; }

bool PlanVerdict::isValid(std::size_t step) const {
  return std::all_of(steps.begin(), steps.end(),
                     [&](const StepVerdict& each) { return each.number != step || each.valid(); });
}

std::size_t PlanVerdict::validSteps() const {
  std::size_t count = 0;
  for (std::size_t step = 1; step <= stepsIn(steps); ++step) count += isValid(step) ? 1 : 0;
  return count;
}

std::size_t PlanVerdict::stepsWithoutProof() const {
  const auto count = [](const std::vector<StepVerdict>& all) {
    return static_cast<std::size_t>(
        std::count_if(all.begin(), all.end(), [](const StepVerdict& step) { return step.isFlexible; }));
  };
  std::size_t sum = count(steps);
  for (const LineVerdict& line : lines) sum += count(line.steps);
  return sum;
}

bool PlanVerdict::valid() const {
  return refusals.empty() && validSteps() == stepsIn(steps) &&
         std::all_of(lines.begin(), lines.end(), [](const LineVerdict& line) { return line.valid(); });
}

bool PlanVerdict::refused() const {
  return !refusals.empty() ||
         std::any_of(steps.begin(), steps.end(), [](const auto& step) { return step.refused(); }) ||
         std::any_of(lines.begin(), lines.end(), [](const auto& line) { return line.refused(); });
}

std::vector<Condition> PlanVerdict::allConditions() const {
  std::vector<Condition> all;
  double clash = 0.0;
  const auto add = [&](const std::vector<Condition>& some) {
    for (const Condition& each : some) {
      clash = std::max(clash, each.acceptedClash);
      const bool isNew = each.acceptedClash == 0.0 && std::find(all.begin(), all.end(), each) == all.end();
      if (isNew) all.push_back(each);
    }
  };
  add(conditions);
  for (const StepVerdict& step : steps) add(step.conditions);
  for (const LineVerdict& line : lines) {
    for (const StepVerdict& step : line.steps) add(step.conditions);
  }
  if (clash > 0.0) all.push_back(clashIsAccepted(clash));
  return all;
}

PlanOutcome PlanVerdict::outcome() const {
  if (!valid()) return refused() ? PlanOutcome::Invalid : PlanOutcome::Undecided;
  if (parts == 0 || remaining > 0 || inGroups > 0) return PlanOutcome::Incomplete;
  return planIsTrusted || allConditions().empty() ? PlanOutcome::Valid : PlanOutcome::Conditional;
}

bool LineVerdict::refused() const {
  return !refusals.empty() || std::any_of(steps.begin(), steps.end(), [](const auto& step) { return step.refused(); });
}

bool LineVerdict::valid() const {
  return refusals.empty() &&
         std::all_of(steps.begin(), steps.end(), [](const StepVerdict& step) { return step.valid(); });
}

PlanVerdict judgePlan(const Product& read, const Plan& plan, std::optional<double> required, const WorkWatch& watch,
                      std::size_t threads) {
  const Product product = withBends(read, plan);
  PlanVerdict verdict;
  PlacedBodies placed;
  const Leaving leaving = leavingOf(plan, product, placed);
  verdict.refusals = wrongClaims(product, plan, leaving.apart);
  verdict.alone = leaving.alone;
  verdict.asUnits = leaving.asUnits;
  verdict.inGroups = leaving.inGroups;
  verdict.conditions = baseOf(plan, product, placed);
  verdict.conditions.insert(verdict.conditions.end(), leaving.conditions.begin(), leaving.conditions.end());
  verdict.deviation = largestTwo(product);
  std::vector<JudgedList> lists;
  lists.push_back({numberedSteps(product, {plan.steps, plan.staying, Present(product.bodies.size(), true)}), {}});
  addLines(plan.lines, plan.steps, {}, product, lists);
  std::size_t removed = 0;
  for (const NumberedStep& step : lists[0].steps) removed += step.group.size();
  verdict.parts = plan.bodies.size() - std::min(plan.bodies.size(), plan.staying.size());
  verdict.remaining = verdict.parts - std::min(verdict.parts, removed);

  std::vector<std::pair<JudgedList*, std::size_t>> open;
  for (JudgedList& list : lists) {
    list.verdict.steps.resize(list.steps.size());
    for (std::size_t i = 0; i < list.steps.size(); ++i) open.emplace_back(&list, i);
  }
  MotionBodies prepared(product.bodies);
  const StepTools tools{product, plan, required, placed, prepared, watch};
  ThreadTeam team(threads - 1);
  std::mutex mutex;
  std::size_t judged = 0;
  team.run(open.size(), [&](std::size_t number) {
    const auto& [list, i] = open[number];
    const NumberedStep& step = list->steps[i];
    StepVerdict& result = list->verdict.steps[i];
    result.bodies = step.step->bodies;
    result.motion.why = GLISSADE_TEXT("the check was stopped");
    result.number = step.step->number;
    result.motionNumber = step.step->motion;
    if (watch.stop.stopRequested()) return;
    result = judgeStep(step, tools);
    const bool isLine = !list->verdict.line.empty();
    judgeDemands(step, plan.demands, product, isLine, result);
    judgeDemands(step, product.demands, product, isLine, result);
    const std::lock_guard lock(mutex);
    watch.report(static_cast<double>(++judged) / static_cast<double>(open.size()));
  });
  verdict.steps = std::move(lists[0].verdict.steps);
  for (std::size_t i = 1; i < lists.size(); ++i) verdict.lines.push_back(std::move(lists[i].verdict));
  return verdict;
}

}  // namespace glissade::check
