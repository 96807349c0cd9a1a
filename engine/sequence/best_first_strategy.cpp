#include "engine/sequence/best_first_strategy.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "engine/sequence/easier_motions.h"
#include "engine/sequence/floating_units.h"
#include "engine/sequence/greedy_strategy.h"
#include "engine/sequence/holding.h"
#include "engine/sequence/joint_removal.h"
#include "engine/sequence/order_search.h"
#include "engine/sequence/plan_steps.h"
#include "engine/sequence/proved_steps.h"
#include "engine/sequence/removal_directions.h"
#include "engine/sequence/step_motion.h"
#include "engine/sequence/step_precedence.h"
#include "engine/sequence/step_stacks.h"
#include "engine/sequence/step_tools.h"

namespace glissade {
namespace {

/// Directions with a larger cosine count as the same direction.
constexpr double kSameWay = 0.98;
/// Limit where support is checked: each step of each state may then need a linear program.
constexpr std::size_t kExpansionsWithStanding = 200;
constexpr std::size_t kMostOrderExpansions = 2000;
/// Half the cost of a change of direction. An order that costs less by a smaller amount is not worth a change.
constexpr double kLeastGain = 0.5;
/// Number of times that floating units are looked for in a new order.
constexpr int kMostLifts = 3;
/// Number of bodies up to which the full limits of expansions hold.
constexpr double kSmallProduct = 30.0;

/// Limit of expansions. It falls with the square of the number of bodies: an expansion asks for each step that may
/// follow, and a linear program contains all bodies that touch.
std::size_t expansionsFor(std::size_t bodies, bool withStanding) {
  const auto most = static_cast<double>(withStanding ? kExpansionsWithStanding : kMostOrderExpansions);
  const double share = kSmallProduct / std::max(kSmallProduct, static_cast<double>(bodies));
  return static_cast<std::size_t>(most * share * share);
}

double massOf(const BodyGroup& group, const SequenceQuestion& question) {
  double mass = 0.0;
  for (const std::size_t body : group) mass += question.standing != nullptr ? question.standing->massOf(body) : 0.0;
  return mass;
}

/// Share of the tree levels that the two bodies' assemblies do not have in common.
double assemblyChangeOf(const std::vector<std::size_t>& one, const std::vector<std::size_t>& other) {
  const std::size_t most = std::max(one.size(), other.size());
  if (most == 0) return 0.0;
  const auto [end, unused] = std::mismatch(
      one.begin(), one.begin() + static_cast<std::ptrdiff_t>(std::min(one.size(), other.size())), other.begin());
  return 1.0 - static_cast<double>(end - one.begin()) / static_cast<double>(most);
}

class Reordering {
 public:
  Reordering(const AssemblyPlan& plan, const SequenceQuestion& question, const StepCost& cost, const StopToken& stop)
      : plan_(plan), question_(question), cost_(cost), stop_(stop), holding_(question) {
    const BodySet all = question.initial();
    const double size = boxOf(question.product, all).diagonal().norm();
    const double volume = boxOf(question.product, all).volume();
    if (cost.uses("tool_blocked") && !question.tools.empty()) tools_.emplace(plan, question);
    for (const AssemblyStep& step : plan.steps) {
      groups_.push_back(groupOf(step, question.product));
      const BodyGroup& group = groups_.back();
      StepFigures figures;
      for (const MotionLeg& leg : legsOf(step.only().path)) {
        figures.length += size > 0.0 ? leg.length / size : 0.0;
        figures.turns += leg.turn / (2.0 * std::numbers::pi);
      }
      figures.bodies = static_cast<double>(group.size());
      figures.mass = massOf(group, question);
      figures.fragile = !question.fragile.empty() && std::any_of(group.begin(), group.end(), [&](std::size_t body) {
        return question.fragile[body];
      });
      figures.id = step.only().body;
      figures.size = volume > 0.0 ? boxVolume(question.product, group) / volume : 0.0;
      figures_.push_back(std::move(figures));
      const std::vector<PathPoint>& path = step.only().path;
      const std::size_t count = path.size();
      const Vector3 way =
          count < 2 ? Vector3(Vector3::Zero()) : Vector3(path[count - 1].q.position - path[count - 2].q.position);
      ways_.push_back(way.norm() > 0.0 ? Vector3(way.normalized()) : way);
      BodySet own(all.size(), false);
      for (const std::size_t body : group) own[body] = true;
      places_.push_back(boxOf(question.product, own).center() / (size > 0.0 ? size : 1.0));
      const Product& tree = question.product.tree;
      const auto node = tree.find(question.product.bodies[group.front()].id.text());
      assemblies_.push_back(node ? tree.assembliesAbove(*node) : std::vector<std::size_t>());
      const bool single = question.joints != nullptr && group.size() == 1;
      tasks_.push_back(single ? question.joints->taskOf(group.front()) : 0);
      stacks_.push_back(single ? question.joints->stackOf(group.front()) : 0);
    }
    findOpeners();
    findIsolated();
  }

  std::vector<std::size_t> order() {
    OrderQuestion question;
    for (const AssemblyStep& step : plan_.steps) {
      question.after.emplace_back();
      for (const std::size_t number : step.after) question.after.back().push_back(number - 1);
    }
    question.cost = [this](std::size_t step, const std::size_t* last, const std::vector<bool>& done) {
      return costOfStep(step, last, done);
    };
    question.atLeast = [this](std::size_t step, const std::size_t* last, const std::vector<bool>& done) {
      return cost_.of(quickFiguresOf(step, last, done));
    };
    question.continues = [this](std::size_t step, std::size_t before) { return isSameStep(step, before); };
    if (!question_.rules.placed.empty()) question.numbers = keptNumbers();
    question.leastGain = kLeastGain;
    question.mostExpansions = expansionsFor(question_.product.bodies.size(), question_.standing != nullptr);
    return cheapestOrder(question, stop_);
  }

 private:
  /// Figures that depend on which steps are done, and not on their order.
  struct SetFigures {
    bool inAir = false;
    double unfastened = 0.0;
    double openStacks = 0.0;
    double falling = 0.0;  ///< this member and the next two are known if isWhole
    double unsupported = 0.0;
    bool toolBlocked = false;
    bool isWhole = false;
  };

  bool isSameStep(std::size_t step, std::size_t before) const {
    return continuesStack(groups_[step], groups_[before], question_.joints);
  }

  /// The numbers of the steps that a person wants at a place, see OrderQuestion::numbers.
  std::vector<std::size_t> keptNumbers() const {
    std::vector<std::size_t> numbers;
    std::size_t number = 0;
    for (std::size_t step = 0; step < groups_.size(); ++step) {
      number += step > 0 && isSameStep(step, step - 1) ? 0 : 1;
      numbers.push_back(question_.rules.placeOf(groups_[step]) != 0 ? number : 0);
    }
    return numbers;
  }

  /// The step of a stack that is found with a tool opens it.
  void findOpeners() {
    for (std::size_t step = 0; step < groups_.size(); ++step) {
      openers_.push_back(step);
      for (std::size_t other = 0; other < groups_.size() && stacks_[step] != 0; ++other) {
        const bool opens = stacks_[other] == stacks_[step] && plan_.steps[other].only().tool.kind != ToolKind::None;
        if (opens) openers_.back() = other;
      }
    }
  }

  void findIsolated() {
    for (const std::size_t body : question_.isolated) {
      const auto alone = std::find(groups_.begin(), groups_.end(), BodyGroup{body});
      if (alone != groups_.end()) isolated_.push_back(static_cast<std::size_t>(alone - groups_.begin()));
    }
  }

  /// The figures without those of SetFigures.
  StepFigures figuresOf(std::size_t step, const std::size_t* last, const std::vector<bool>& done) const {
    StepFigures figures = figures_[step];
    const bool isOneOperation = last != nullptr && isSameStep(step, *last);
    if (!isOneOperation) addChanges(figures, step, last == nullptr ? nullptr : &openers_[*last]);
    figures.distance = last == nullptr ? 0.0 : (places_[step] - places_[*last]).norm();
    const auto left = std::count(done.begin(), done.end(), false);
    figures.early = static_cast<double>(left - 1) / static_cast<double>(done.size());
    for (const std::size_t other : isolated_) figures.isolatedLeft += other != step && !done[other] ? 1.0 : 0.0;
    return figures;
  }

  int senseOf(std::size_t step) const { return glissade::senseOf(ways_[step], question_.up); }

  /// Adds what changes after the step `last`.
  void addChanges(StepFigures& figures, std::size_t step, const std::size_t* last) const {
    figures.directionChange = last == nullptr || ways_[step].dot(ways_[*last]) < kSameWay;
    figures.turnOver = last == nullptr ? 0.0 : 0.5 * std::abs(senseOf(step) - senseOf(*last));
    figures.toolChange = last == nullptr || usesAnotherTool(plan_.steps[step].only(), plan_.steps[*last].only());
    figures.taskChange = last == nullptr || tasks_[step] == 0 || tasks_[step] != tasks_[*last];
    figures.assemblyChange = last == nullptr ? 0.0 : assemblyChangeOf(assemblies_[step], assemblies_[*last]);
  }

  double costOfStep(std::size_t step, const std::size_t* last, const std::vector<bool>& done) {
    StepFigures figures = quickFiguresOf(step, last, done);
    SetFigures& ofSet = figuresOfSet(step, done);
    if (!ofSet.isWhole) addSlowFigures(step, done, ofSet);
    figures.falling = ofSet.falling;
    figures.unsupported = ofSet.unsupported;
    figures.toolBlocked = ofSet.toolBlocked;
    return cost_.of(figures);
  }

  /// All figures but the falling bodies and the access of the tool.
  StepFigures quickFiguresOf(std::size_t step, const std::size_t* last, const std::vector<bool>& done) {
    StepFigures figures = figuresOf(step, last, done);
    const SetFigures& ofSet = figuresOfSet(step, done);
    figures.inAir = ofSet.inAir;
    figures.unfastened = ofSet.unfastened;
    figures.openStacks = ofSet.openStacks;
    return figures;
  }

  SetFigures& figuresOfSet(std::size_t step, const std::vector<bool>& done) {
    const auto [known, isNew] = ofSets_.try_emplace({done, step});
    SetFigures& figures = known->second;
    if (!isNew) return figures;
    const BodySet remaining = without(presentAfter(done), groups_[step]);
    if (cost_.uses("in_air")) figures.inAir = holding_.isInAir(groups_[step], remaining);
    if (cost_.uses("unfastened")) figures.unfastened = static_cast<double>(holding_.unfastened(remaining));
    if (cost_.uses("open_stacks")) figures.openStacks = static_cast<double>(holding_.openStacks(remaining));
    return figures;
  }

  void addSlowFigures(std::size_t step, const std::vector<bool>& done, SetFigures& figures) {
    const BodySet present = presentAfter(done);
    const BodySet rest = without(present, groups_[step]);
    if (question_.standing != nullptr && cost_.uses("falling")) {
      figures.falling = static_cast<double>(question_.standing->newlyFalling(present, groups_[step]).size());
    }
    if (question_.standing != nullptr && cost_.uses("unsupported")) {
      figures.unsupported = static_cast<double>(question_.standing->falling(rest).size());
    }
    if (tools_) {
      const auto tool = tools_->toolOf(step, rest, stop_);
      figures.toolBlocked = tool && tool->access == ToolAccess::Blocked;
    }
    figures.isWhole = true;
  }

  BodySet presentAfter(const std::vector<bool>& done) const {
    BodySet present = question_.initial();
    for (std::size_t step = 0; step < done.size(); ++step) {
      if (done[step]) present = without(std::move(present), groups_[step]);
    }
    return present;
  }

  static bool usesAnotherTool(const StepMotion& one, const StepMotion& other) {
    return one.fastener != other.fastener || one.tool.kind != other.tool.kind;
  }

  const AssemblyPlan& plan_;
  const SequenceQuestion& question_;
  const StepCost& cost_;
  const StopToken& stop_;
  Holding holding_;
  std::vector<BodyGroup> groups_;
  std::vector<StepFigures> figures_;  ///< figures that do not depend on the order
  std::vector<Vector3> ways_;         ///< direction at the end of each step, unit; zero where it only turns
  std::vector<Vector3> places_;       ///< centre of each step's bodies, divided by the diagonal of the product's box
  std::vector<std::vector<std::size_t>> assemblies_;  ///< tree path of the first body's assembly, for each step
  std::vector<std::size_t> tasks_;
  std::vector<std::size_t> stacks_;
  std::vector<std::size_t> openers_;   ///< the step that opens the stack of each step; without a stack, the step itself
  std::vector<std::size_t> isolated_;  ///< steps of bodies that touch nothing
  std::map<std::pair<std::vector<bool>, std::size_t>, SetFigures> ofSets_;  ///< computed once
  std::optional<ToolFacts> tools_;  ///< set if the cost uses the access of tools
};

/// Carries out the steps in the cheapest order, where each of them is certified in it.
void putInOrder(AssemblyPlan& plan, const SequenceQuestion& question, const StopToken& stop) {
  const auto usual = StepCost::of(SequenceDemands());
  const StepCost& cost = question.cost != nullptr ? *question.cost : *usual;
  const auto order = Reordering(plan, question, cost, stop).order();
  if (std::is_sorted(order.begin(), order.end())) return;
  if (auto certified = certifiedInOrder(provedSteps(plan, order, question), question, stop)) {
    plan.steps = std::move(*certified);
  }
}

}  // namespace

AssemblyPlan BestFirstStrategy::plan(const SequenceQuestion& question, SequenceHost& host) {
  const StopToken& stop = host.stopToken();
  AssemblyPlan plan = GreedyStrategy().plan(question, host);
  plan.strategy = "best-first";
  if (plan.end == PlanEnd::Interrupted || stop.stopRequested()) return plan;
  putInOrder(plan, question, stop);
  for (int pass = 0; pass < kMostLifts && liftFloatingUnits(plan, question, host); ++pass) {
    addPrecedence(plan, question, host);
    putInOrder(plan, question, stop);
  }
  if (!takeEasierMotions(plan, question, stop)) return plan;
  addPrecedence(plan, question, host);
  putInOrder(plan, question, stop);
  return plan;
}

}  // namespace glissade
