#include "engine/sequence/greedy_strategy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <set>

#include "engine/base/random_stream.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

/// A trial in which a body may leave after certain other bodies, each with an effort.
class RuledTrial final : public RemovalTrial {
 public:
  struct Rule {
    std::set<std::size_t> blockedBy;
    int effort = 0;
  };
  explicit RuledTrial(std::vector<Rule> rules) : rules_(std::move(rules)) {}

  int efforts() const override { return 3; }
  RemovalAnswer tryRemoval(const BodyGroup& group, const BodySet& present, int effort, const StopToken&) override {
    const std::lock_guard lock(mutex_);
    if (group.size() > 1) return Refused{bodiesIn(without(present, group)), false};
    const std::size_t body = group.front();
    std::vector<std::size_t> blocking;
    for (const std::size_t other : rules_[body].blockedBy) {
      if (present[other]) blocking.push_back(other);
    }
    // Detects a repeated trial although none of the blocking bodies has left.
    auto& last = asked_[{body, effort}];
    if (last) {
      EXPECT_NE(*last, blocking) << body << " with effort " << effort;
    }
    last = blocking;
    if (!blocking.empty() || effort < rules_[body].effort) return Refused{blocking, false};
    Path path{{{Pose::identity(), Author::Computer}, {Pose::translation({1.0, 0.0, 0.0}), Author::Computer}}, {}};
    return Removed{path, "ruled", {}};
  }
  std::vector<BodyGroup> groupsAlongLines(const GroupQuestion&, ThreadTeam&, const StopToken&) override { return {}; }
  std::vector<std::size_t> inTheWay(const BodyGroup& group, const std::vector<PathPoint>&,
                                    const std::vector<std::size_t>& left, const StopToken&) override {
    std::vector<std::size_t> blocking;
    for (const std::size_t other : left) {
      if (rules_[group.front()].blockedBy.count(other) != 0) blocking.push_back(other);
    }
    return blocking;
  }
  std::optional<Removed> certified(const BodyGroup&, const std::vector<PathPoint>& path, const std::string& method,
                                   const BodySet&, const StopToken&) override {
    return Removed{{path, {}}, method, {}};
  }
  void learn(const BodyGroup& group, const std::vector<PathPoint>&) override { learned.push_back(group.front()); }

  std::vector<std::size_t> learned;

 private:
  std::vector<Rule> rules_;
  std::mutex mutex_;
  std::map<std::pair<std::size_t, int>, std::optional<std::vector<std::size_t>>> asked_;
};

AssembledProduct boxes(std::size_t count) {
  std::vector<RigidBody> bodies;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 2.0 * static_cast<double>(i);
    bodies.push_back(boxBody(std::to_string(i), Vector3::Constant(1.0), Pose::translation({x, 0.0, 0.0})));
  }
  return test::productOf(bodies);
}

/// Interrupted after this number of waves.
AssemblyPlan planned(const AssembledProduct& product, RemovalTrial& trial, const AssemblyPlan* resumed = nullptr,
                     std::size_t waves = 1000) {
  test::QuietHost host(1, waves);
  BodySet staying(product.bodies.size(), false);
  staying[0] = true;
  return GreedyStrategy().plan({product, staying, 1, trial, resumed}, host);
}

/// Each body is blocked by bodies of lower or higher numbers; some chains end in a circle.
std::vector<RuledTrial::Rule> randomRules(RandomStream& random, std::size_t count) {
  std::vector<RuledTrial::Rule> rules(count);
  for (std::size_t body = 1; body < count; ++body) {
    for (std::size_t other = 1; other < count; ++other) {
      const double chance = other > body ? 0.15 : 0.01;
      if (other != body && random.uniform() < chance) rules[body].blockedBy.insert(other);
    }
    rules[body].effort = static_cast<int>(random.uniform(0.0, 3.0));
  }
  return rules;
}

/// Removes bodies in any order while one can leave: the rest is the largest set that blocks itself.
std::set<std::size_t> leftForEver(const std::vector<RuledTrial::Rule>& rules) {
  std::set<std::size_t> left;
  for (std::size_t body = 1; body < rules.size(); ++body) left.insert(body);
  for (bool changed = true; changed;) {
    changed = false;
    for (const std::size_t body : std::set<std::size_t>(left)) {
      const bool blocked = std::any_of(rules[body].blockedBy.begin(), rules[body].blockedBy.end(),
                                       [&](std::size_t other) { return left.count(other) != 0; });
      if (blocked) continue;
      left.erase(body);
      changed = true;
    }
  }
  return left;
}

TEST(GreedyStrategy, TakesOutWhateverCanLeaveAndNamesWhatIsInTheWay) {
  RandomStream random(1, "greedy");
  for (int round = 0; round < 50; ++round) {
    const AssembledProduct product = boxes(12);
    const auto rules = randomRules(random, 12);
    RuledTrial trial(rules);
    const AssemblyPlan plan = planned(product, trial);
    const std::set<std::size_t> left = leftForEver(rules);
    EXPECT_EQ(plan.steps.size(), 11 - left.size());
    EXPECT_EQ(plan.end, left.empty() ? PlanEnd::Complete : PlanEnd::Stuck);
    ASSERT_EQ(plan.stuck.size(), left.size());
    for (const StuckBody& stuck : plan.stuck) {
      std::vector<BodyId> blocking;
      for (const std::size_t other : rules[product.indexOf(stuck.body)].blockedBy) {
        if (left.count(other) != 0) blocking.emplace_back(std::to_string(other));
      }
      EXPECT_EQ(stuck.blockedBy.size(), blocking.size());
      EXPECT_TRUE(std::is_permutation(blocking.begin(), blocking.end(), stuck.blockedBy.begin()));
    }
  }
}

TEST(GreedyStrategy, GoesOnFromAnyWaveToTheSamePlan) {
  RandomStream random(2, "greedy");
  for (int round = 0; round < 20; ++round) {
    const AssembledProduct product = boxes(10);
    const auto rules = randomRules(random, 10);
    RuledTrial whole(rules);
    const AssemblyPlan plan = planned(product, whole);
    if (plan.steps.empty()) continue;
    for (std::size_t waves = 1; waves <= plan.steps.back().wave; ++waves) {
      RuledTrial begun(rules);
      const AssemblyPlan cut = planned(product, begun, nullptr, waves);
      EXPECT_EQ(cut.steps.back().wave, waves);
      RuledTrial rest(rules);
      const AssemblyPlan resumed = planned(product, rest, &cut);
      EXPECT_EQ(test::orderOf(resumed), test::orderOf(plan));
      EXPECT_EQ(resumed.refusals.size(), plan.refusals.size());
      EXPECT_EQ(rest.learned.size(), plan.steps.size());
    }
  }
}

TEST(GreedyStrategy, NamesTheStepsThatHaveToBeCarriedOutBefore) {
  RandomStream random(5, "precedence");
  for (int round = 0; round < 30; ++round) {
    const AssembledProduct product = boxes(12);
    const auto rules = randomRules(random, 12);
    RuledTrial trial(rules);
    const AssemblyPlan plan = planned(product, trial);
    for (std::size_t step = 0; step < plan.steps.size(); ++step) {
      const auto& blockedBy = rules[product.indexOf(plan.steps[step].only().body)].blockedBy;
      for (std::size_t other = 0; other < step; ++other) {
        const bool needed = blockedBy.count(product.indexOf(plan.steps[other].only().body)) != 0;
        const auto& after = plan.steps[step].after;
        EXPECT_EQ(std::count(after.begin(), after.end(), other + 1), needed ? 1 : 0);
      }
    }
  }
}

TEST(GreedyStrategy, KeepsTheOrderThatAPersonDemandsAndSaysSoWhereItIsInTheWay) {
  const AssembledProduct product = boxes(4);
  std::vector<RuledTrial::Rule> rules(4);
  RuledTrial free(rules);
  test::QuietHost host;
  const BodySet staying{true, false, false, false};
  const AssemblyPlan kept =
      GreedyStrategy().plan({product, staying, 1, free, nullptr, {{}, {{3, 1, true}, {1, 2, true}}}}, host);
  EXPECT_EQ(test::orderOf(kept), (std::vector<BodyId>{"3", "1", "2"}));
  EXPECT_EQ(kept.steps[1].after, std::vector<std::size_t>{1});
  rules[3].blockedBy = {0};
  RuledTrial blocked(rules);
  const AssemblyPlan stuck = GreedyStrategy().plan({product, staying, 1, blocked, nullptr, {{}, {{3, 1, true}}}}, host);
  EXPECT_EQ(test::orderOf(stuck), std::vector<BodyId>{"2"});
  ASSERT_EQ(stuck.stuck.size(), 2U);
  EXPECT_EQ(stuck.stuck[0].body, "1");
  EXPECT_EQ(stuck.stuck[0].blockedBy, std::vector<BodyId>{"3"});
  EXPECT_NE(toString(stuck.stuck[0].reason).find("constraint"), std::string::npos);
  // A rule that is known but not demanded is dropped if no other body can leave.
  RuledTrial known(rules);
  const AssemblyPlan given = GreedyStrategy().plan({product, staying, 1, known, nullptr, {{}, {{3, 1, false}}}}, host);
  EXPECT_EQ(test::orderOf(given), (std::vector<BodyId>{"2", "1"}));
}

TEST(GreedyStrategy, FragileBodiesLeaveFirst) {
  const AssembledProduct product = boxes(4);
  RuledTrial trial(std::vector<RuledTrial::Rule>(4));
  test::QuietHost host;
  SequenceQuestion question{product, {true, false, false, false}, 1, trial};
  question.fragile = {false, false, true, false};
  EXPECT_EQ(test::orderOf(GreedyStrategy().plan(question, host)), (std::vector<BodyId>{"2", "1", "3"}));
}

TEST(GreedyStrategy, StopsWithThePlanSoFar) {
  const AssembledProduct product = boxes(3);
  RuledTrial trial(std::vector<RuledTrial::Rule>(3));
  const AssemblyPlan plan = planned(product, trial, nullptr, 0);
  EXPECT_TRUE(plan.steps.empty());
  EXPECT_EQ(plan.end, PlanEnd::Interrupted);
  EXPECT_TRUE(plan.stuck.empty()) << "nobody was asked";
}

TEST(GreedyStrategy, APartThatWasNotAskedToTheEndSaysThatPlanningWasStopped) {
  const AssembledProduct product = boxes(4);
  std::vector<RuledTrial::Rule> rules(4);
  rules[3].blockedBy = {0};
  RuledTrial trial(rules);
  const AssemblyPlan plan = planned(product, trial, nullptr, 1);
  EXPECT_EQ(plan.end, PlanEnd::Interrupted);
  ASSERT_EQ(plan.stuck.size(), 1U);
  EXPECT_EQ(toString(plan.stuck[0].reason), "planning was stopped before every motion of it was tried");
}

}  // namespace
}  // namespace glissade
