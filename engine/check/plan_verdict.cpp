#include "engine/check/plan_verdict.h"

#include <algorithm>
#include <functional>
#include <mutex>
#include <set>
#include <thread>

#include "engine/base/thread_team.h"
#include "engine/check/path_verdict.h"
#include "engine/check/step_judge.h"

namespace glissade::check {
namespace {

/// Deeper than groups of groups come.
constexpr std::size_t kMostDepth = 32;

/// The two largest, together.
double largestTwo(const Product& product) {
  std::vector<double> values(2, 0.0);
  for (const Body& body : product.bodies) values.push_back(deflectionOf(body));
  std::partial_sort(values.begin(), values.begin() + 2, values.end(), std::greater<>());
  return values[0] + values[1];
}

/// A list of steps, and what is said of it.
struct JudgedList {
  std::vector<NumberedStep> steps;
  LineVerdict verdict;
};

Present presentOnly(const std::vector<std::string>& ids, const Product& product) {
  Present there(product.bodies.size(), false);
  for (std::size_t body = 0; body < there.size(); ++body) {
    there[body] = std::find(ids.begin(), ids.end(), product.bodies[body].id) != ids.end();
  }
  return there;
}

/// What of a line's claims does not agree with the step by which its group has left.
std::vector<std::string> wrongLine(const Line& line, const std::vector<Step>& above) {
  if (line.step == 0 || line.step > above.size())
    return {"it is of step " + std::to_string(line.step) + ", which is none"};
  const auto& group = above[line.step - 1].bodies;
  std::vector<std::string> wrong;
  if (std::set<std::string>(group.begin(), group.end()) !=
          std::set<std::string>(line.bodies.begin(), line.bodies.end()) ||
      group.size() != line.bodies.size()) {
    wrong.emplace_back("its bodies are not those of its step");
  }
  for (const std::string& id : line.staying) {
    if (std::find(group.begin(), group.end(), id) != group.end()) continue;
    wrong.push_back("'" + id + "' is said to stay and is not in the group");
  }
  return wrong;
}

/// The lines of these steps, and those below them.
void addLines(const std::vector<Line>& lines, const std::vector<Step>& above, const std::vector<std::size_t>& way,
              const Product& product, std::vector<JudgedList>& lists) {
  std::set<std::size_t> known;
  for (const Line& line : lines) {
    std::vector<std::size_t> numbers = way;
    numbers.push_back(line.step);
    JudgedList list{numberedSteps(product, {line.steps, line.staying, presentOnly(line.bodies, product)}),
                    {numbers, {}, wrongLine(line, above)}};
    if (!known.insert(line.step).second) list.verdict.refusals.emplace_back("its step has another line");
    lists.push_back(std::move(list));
    if (numbers.size() < kMostDepth) addLines(line.lines, line.steps, numbers, product, lists);
  }
}

/// What a person says about the places and motions of steps, and about steps of several bodies, is about those of the
/// plan.
Demands ofLines(Demands demands) {
  demands.places.clear();
  demands.motions.clear();
  demands.together.clear();
  return demands;
}

/// The product's file says of joints before the plan does.
Product withWords(Product product, const Plan& plan) {
  for (const SnapWord& word : plan.snaps) {
    if (product.fits.snapOf(word.hook, word.edge) == nullptr) product.fits.snaps.push_back(word);
  }
  PartingWords& partings = product.fits.partings;
  partings.anyPair = partings.anyPair || plan.partings.anyPair;
  partings.pairs.insert(partings.pairs.end(), plan.partings.pairs.begin(), plan.partings.pairs.end());
  return product;
}

}  // namespace

std::size_t PlanVerdict::validSteps() const {
  return static_cast<std::size_t>(
      std::count_if(steps.begin(), steps.end(), [](const StepVerdict& step) { return step.valid(); }));
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
  return refusals.empty() && validSteps() == steps.size() &&
         std::all_of(lines.begin(), lines.end(), [](const LineVerdict& line) { return line.valid(); });
}

bool PlanVerdict::refused() const {
  return !refusals.empty() ||
         std::any_of(steps.begin(), steps.end(), [](const auto& step) { return step.refused(); }) ||
         std::any_of(lines.begin(), lines.end(), [](const auto& line) { return line.refused(); });
}

bool LineVerdict::refused() const {
  return !refusals.empty() || std::any_of(steps.begin(), steps.end(), [](const auto& step) { return step.refused(); });
}

bool LineVerdict::valid() const {
  return refusals.empty() &&
         std::all_of(steps.begin(), steps.end(), [](const StepVerdict& step) { return step.valid(); });
}

PlanVerdict judgePlan(const Product& read, const Plan& plan, std::optional<double> required, const WorkWatch& watch) {
  const Product product = withWords(read, plan);
  PlanVerdict verdict;
  verdict.refusals = wrongClaims(product, plan);
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
  PlacedBodies placed;
  MotionBodies prepared(product.bodies);
  const StepTools tools{product, required, placed, prepared, watch};
  ThreadTeam team(std::max(1U, std::thread::hardware_concurrency()) - 1);
  std::mutex mutex;
  std::size_t judged = 0;
  team.run(open.size(), [&](std::size_t number) {
    const auto& [list, i] = open[number];
    const NumberedStep& step = list->steps[i];
    StepVerdict& result = list->verdict.steps[i];
    result.bodies = step.step->bodies;
    result.motion.why = "the check was stopped";
    if (watch.stop.stopRequested()) return;
    result = judgeStep(step, tools);
    const bool isLine = !list->verdict.line.empty();
    for (const Demands* demands : {&plan.demands, &product.demands}) {
      if (!result.againstDemand.empty()) continue;
      result.againstDemand =
          againstDemands(*step.step, step.group, step.there, i + 1, product, isLine ? ofLines(*demands) : *demands);
    }
    const std::lock_guard lock(mutex);
    watch.report(static_cast<double>(++judged) / static_cast<double>(open.size()));
  });
  verdict.steps = std::move(lists[0].verdict.steps);
  for (std::size_t i = 1; i < lists.size(); ++i) verdict.lines.push_back(std::move(lists[i].verdict));
  return verdict;
}

}  // namespace glissade::check
