#include "engine/sequence/best_first_strategy.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/sequence/greedy_strategy.h"
#include "engine/sequence/order_search.h"
#include "engine/sequence/plan_steps.h"
#include "engine/sequence/step_motion.h"

namespace glissade {
namespace {

/// Cosine above which two directions are one.
constexpr double kSameWay = 0.98;
/// Where it is asked what stands, a linear program for each step of each state may be solved.
constexpr std::size_t kExpansionsWithStanding = 200;
constexpr std::size_t kMostOrderExpansions = 2000;

double massOf(const BodyGroup& group, const SequenceQuestion& question) {
  double mass = 0.0;
  for (const std::size_t body : group) mass += question.standing != nullptr ? question.standing->massOf(body) : 0.0;
  return mass;
}

class Reordering {
 public:
  Reordering(const AssemblyPlan& plan, const SequenceQuestion& question, const StepCost& cost)
      : plan_(plan), question_(question), cost_(cost) {
    const BodySet all(question.product.bodies.size(), true);
    const double size = boxOf(question.product, all).diagonal().norm();
    for (const AssemblyStep& step : plan.steps) {
      groups_.push_back(groupOf(step, question.product));
      StepFigures figures;
      for (const MotionLeg& leg : legsOf(step.path)) {
        figures.length += size > 0.0 ? leg.length / size : 0.0;
        figures.turns += leg.turn / (2.0 * std::numbers::pi);
      }
      const BodyGroup& group = groups_.back();
      figures.bodies = static_cast<double>(group.size());
      figures.mass = massOf(group, question);
      figures.fragile = !question.fragile.empty() && std::any_of(group.begin(), group.end(), [&](std::size_t body) {
        return question.fragile[body];
      });
      figures.id = step.body;
      figures_.push_back(std::move(figures));
      const std::size_t count = step.path.size();
      const Vector3 way = count < 2 ? Vector3(Vector3::Zero())
                                    : Vector3(step.path[count - 1].q.position - step.path[count - 2].q.position);
      ways_.push_back(way.norm() > 0.0 ? Vector3(way.normalized()) : way);
    }
  }

  std::vector<std::size_t> order(const StopToken& stop) const {
    OrderQuestion question;
    for (const AssemblyStep& step : plan_.steps) {
      question.after.emplace_back();
      for (const std::size_t number : step.after) question.after.back().push_back(number - 1);
    }
    question.cost = [this](std::size_t step, const std::size_t* last, const std::vector<bool>& done) {
      return costOfStep(step, last, done);
    };
    if (!question_.rules.placed.empty()) {
      for (const BodyGroup& group : groups_) question.fixed.push_back(question_.rules.placeOf(group) != 0);
    }
    question.mostExpansions = question_.standing != nullptr ? kExpansionsWithStanding : kMostOrderExpansions;
    return cheapestOrder(question, stop);
  }

 private:
  double costOfStep(std::size_t step, const std::size_t* last, const std::vector<bool>& done) const {
    StepFigures figures = figures_[step];
    figures.directionChange = last == nullptr || ways_[step].dot(ways_[*last]) < kSameWay;
    figures.toolChange = last == nullptr || usesAnotherTool(plan_.steps[step], plan_.steps[*last]);
    if (question_.standing == nullptr) return cost_.of(figures);
    BodySet present(question_.product.bodies.size(), true);
    for (std::size_t other = 0; other < done.size(); ++other) {
      if (done[other]) present = without(std::move(present), groups_[other]);
    }
    figures.falling = static_cast<double>(question_.standing->newlyFalling(present, groups_[step]).size());
    return cost_.of(figures);
  }

  static bool usesAnotherTool(const AssemblyStep& one, const AssemblyStep& other) {
    return one.fastener != other.fastener || one.tool.kind != other.tool.kind;
  }

  const AssemblyPlan& plan_;
  const SequenceQuestion& question_;
  std::vector<BodyGroup> groups_;
  const StepCost& cost_;
  std::vector<StepFigures> figures_;  ///< what does not depend on the order
  std::vector<Vector3> ways_;         ///< at the end, unit; zero where it only turns
};

/// The steps in another order, each certified against the bodies that are there then; nothing where that fails.
std::optional<std::vector<AssemblyStep>> reordered(const AssemblyPlan& plan, const std::vector<std::size_t>& order,
                                                   const SequenceQuestion& question, const StopToken& stop) {
  std::vector<std::size_t> numberOf(order.size());
  for (std::size_t place = 0; place < order.size(); ++place) numberOf[order[place]] = place + 1;
  std::vector<AssemblyStep> steps;
  BodySet present(question.product.bodies.size(), true);
  for (const std::size_t step : order) {
    const AssemblyStep& earlier = plan.steps[step];
    const BodyGroup group = groupOf(earlier, question.product);
    const auto removed = question.trial.certified(group, earlier.path, earlier.method, present, stop);
    if (!removed) return std::nullopt;
    AssemblyStep next = makeStep(group, *removed, question, steps.size());
    next.wave = steps.size() + 1;
    for (const std::size_t number : earlier.after) next.after.push_back(numberOf[number - 1]);
    std::sort(next.after.begin(), next.after.end());
    BodyGroup falling;
    if (question.standing != nullptr) falling = question.standing->newlyFalling(present, group);
    next.falling = idsOf(falling, question.product);
    if (question.rules.placeOf(group) != 0) {
      next.violates = violationsOf(group, present, falling, steps.size() + 1, question);
    }
    present = without(present, group);
    steps.push_back(std::move(next));
  }
  return steps;
}

}  // namespace

AssemblyPlan BestFirstStrategy::plan(const SequenceQuestion& question, SequenceHost& host) {
  AssemblyPlan plan = GreedyStrategy().plan(question, host);
  plan.strategy = "best-first";
  if (plan.end == PlanEnd::Interrupted || host.stopToken().stopRequested()) return plan;
  const auto usual = StepCost::of(SequenceDemands());
  const StepCost& cost = question.cost != nullptr ? *question.cost : *usual;
  const auto order = Reordering(plan, question, cost).order(host.stopToken());
  if (auto steps = reordered(plan, order, question, host.stopToken())) plan.steps = std::move(*steps);
  return plan;
}

}  // namespace glissade
