#include "engine/sequence/best_first_strategy.h"

#include <algorithm>
#include <optional>

#include "engine/sequence/greedy_strategy.h"
#include "engine/sequence/order_search.h"
#include "engine/sequence/plan_steps.h"

namespace glissade {
namespace {

constexpr double kCostOfTurning = 1.0;
constexpr double kCostOfTool = 1.0;
constexpr double kCostOfFalling = 10.0;
/// Cosine above which two directions are one.
constexpr double kSameWay = 0.98;
/// Where it is asked what stands, a linear program for each step of each state may be solved.
constexpr std::size_t kExpansionsWithStanding = 200;
constexpr std::size_t kMostOrderExpansions = 2000;

class Reordering {
 public:
  Reordering(const AssemblyPlan& plan, const SequenceQuestion& question) : plan_(plan), question_(question) {
    const BodySet all(question.product.bodies.size(), true);
    const double size = boxOf(question.product, all).diagonal().norm();
    for (const AssemblyStep& step : plan.steps) {
      groups_.push_back(groupOf(step, question.product));
      double length = 0.0;
      for (std::size_t i = 1; i < step.path.size(); ++i) {
        length += (step.path[i].q.position - step.path[i - 1].q.position).norm();
      }
      lengths_.push_back(size > 0.0 ? length / size : 0.0);
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
    question.mostExpansions = question_.standing != nullptr ? kExpansionsWithStanding : kMostOrderExpansions;
    return cheapestOrder(question, stop);
  }

 private:
  double costOfStep(std::size_t step, const std::size_t* last, const std::vector<bool>& done) const {
    double cost = lengths_[step];
    if (last == nullptr || ways_[step].dot(ways_[*last]) < kSameWay) cost += kCostOfTurning;
    if (last == nullptr || plan_.steps[step].fastener != plan_.steps[*last].fastener) cost += kCostOfTool;
    if (question_.standing == nullptr) return cost;
    BodySet present(question_.product.bodies.size(), true);
    for (std::size_t other = 0; other < done.size(); ++other) {
      if (done[other]) present = without(std::move(present), groups_[other]);
    }
    const auto falling = question_.standing->newlyFalling(present, groups_[step]).size();
    return cost + kCostOfFalling * static_cast<double>(falling);
  }

  const AssemblyPlan& plan_;
  const SequenceQuestion& question_;
  std::vector<BodyGroup> groups_;
  std::vector<double> lengths_;  ///< by the product's size
  std::vector<Vector3> ways_;    ///< at the end, unit; zero where it only turns
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
    if (question.standing != nullptr) {
      next.falling = idsOf(question.standing->newlyFalling(present, group), question.product);
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
  const auto order = Reordering(plan, question).order(host.stopToken());
  if (auto steps = reordered(plan, order, question, host.stopToken())) plan.steps = std::move(*steps);
  return plan;
}

}  // namespace glissade
