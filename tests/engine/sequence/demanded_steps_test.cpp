#include "engine/sequence/demand_edits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/tolerances.h"
#include "engine/files/judged_product.h"
#include "engine/sequence/demand_conflicts.h"
#include "engine/sequence/demanding_trial.h"
#include "engine/sequence/sequence_run.h"
#include "engine/sequence/step_motion.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

using Names = std::vector<std::string>;

AssemblyPlan planOfSteps(const Names& order) {
  AssemblyPlan plan;
  for (const std::string& id : order) {
    AssemblyStep step{{StepMotion()}};
    step.only().body = BodyId(id);
    step.only().path = {{Pose::identity(), Author::Computer}, {Pose::translation({0.0, 0.0, 1.0}), Author::Computer}};
    step.only().method = "straight";
    plan.steps.push_back(step);
  }
  return plan;
}

std::vector<std::pair<std::string, std::size_t>> placesOf(const SequenceDemands& demands) {
  std::vector<std::pair<std::string, std::size_t>> places;
  for (const DemandedPlace& each : demands.places) places.emplace_back(each.bodies.front(), each.place);
  return places;
}
using Places = std::vector<std::pair<std::string, std::size_t>>;

TEST(DemandedSteps, AMovedStepHasAPlaceAndOthersThatHaveOneMakeWay) {
  const AssemblyPlan plan = planOfSteps({"a", "b", "c", "d", "e"});
  SequenceDemands demands = withStepMoved(3, 1, plan, {});
  EXPECT_EQ(placesOf(demands), (Places{{"d", 2}}));
  const AssemblyPlan moved = planOfSteps({"a", "d", "b", "c", "e"});
  demands = withStepMoved(4, 0, moved, demands);
  EXPECT_EQ(placesOf(demands), (Places{{"e", 1}, {"d", 3}}));
  demands = withStepMoved(2, 4, planOfSteps({"e", "a", "d", "b", "c"}), demands);
  EXPECT_EQ(placesOf(demands), (Places{{"e", 1}, {"d", 5}}));
}

TEST(DemandedSteps, ALockedStepKeepsItsPlaceAndItsMotion) {
  const AssemblyPlan plan = planOfSteps({"a", "b", "c", "d"});
  SequenceDemands demands = withStepLocked(1, true, plan, {});
  ASSERT_EQ(demands.motions.size(), 1U);
  EXPECT_EQ(demands.motions[0].method, "straight");
  EXPECT_TRUE(demandsOn({"b"}, demands).isLocked());
  demands = withStepMoved(3, 1, plan, demands);
  EXPECT_EQ(placesOf(demands), (Places{{"b", 2}, {"d", 3}})) << "beside the locked one";
  demands = withStepMoved(3, 0, plan, withStepLocked(1, true, plan, {}));
  EXPECT_EQ(placesOf(demands), (Places{{"d", 1}, {"b", 2}}));
  demands = withStepLocked(1, false, plan, demands);
  EXPECT_EQ(placesOf(demands), (Places{{"d", 1}}));
  EXPECT_TRUE(demands.motions.empty());
}

/// The place is that of the first motion of the step, and the other ones follow it.
TEST(DemandedSteps, AStackIsMovedAndLockedAsOneStep) {
  AssemblyPlan plan = planOfSteps({"a", "nut", "b"});
  plan.steps[1].motions.push_back(planOfSteps({"bolt"}).steps[0].only());
  const SequenceDemands moved = withStepMoved(1, 0, plan, {});
  EXPECT_EQ(placesOf(moved), (Places{{"nut", 1}}));
  EXPECT_EQ(placesOf(withStepMoved(1, 2, plan, moved)), (Places{{"nut", 3}}));
  const SequenceDemands locked = withStepLocked(1, true, plan, {});
  EXPECT_EQ(placesOf(locked), (Places{{"nut", 2}}));
  ASSERT_EQ(locked.motions.size(), 2U);
  EXPECT_EQ(locked.motions[1].bodies, Names{"bolt"});
  EXPECT_TRUE(demandsOn(plan.steps[1].bodies(), locked).isLocked());
  EXPECT_EQ(withStepLocked(1, false, plan, locked), SequenceDemands());
  EXPECT_EQ(withoutDemandsOn(plan.steps[1].bodies(), locked), SequenceDemands());
}

TEST(DemandedSteps, TwoStepsNeverHaveOnePlace) {
  SequenceDemands demands;
  demands.places = {{{"stuck"}, 2}};
  demands = withStepMoved(0, 1, planOfSteps({"a", "b"}), demands);
  EXPECT_EQ(placesOf(demands), (Places{{"a", 2}, {"stuck", 3}}));
}

TEST(DemandedSteps, EditsAreTakenBackTogether) {
  const AssemblyPlan plan = planOfSteps({"a", "b", "c"});
  SequenceDemands demands = withStepLocked(0, true, plan, {});
  demands = withOrder({{"a"}, {"b"}, {"c"}}, demands);
  EXPECT_EQ(demands.before, (std::vector<std::pair<std::string, std::string>>{{"a", "b"}, {"b", "c"}}));
  demands = withForbidden({"a"}, {0.0, 0.0, 2.0}, demands);
  EXPECT_EQ(demandsOn({"a"}, demands).forbidden.size(), 1U);
  demands = withoutDemandsOn({"b"}, withoutDemandsOn({"a"}, demands));
  EXPECT_EQ(demands, SequenceDemands());
}

TEST(DemandConflicts, NoDemandGoesBecauseAnotherOneComes) {
  const AssemblyPlan plan = planOfSteps({"a", "b", "c"});
  const SequenceDemands kept = withStepLocked(0, true, plan, {});
  const SequenceDemands both = withForbidden({"a"}, {0.0, 0.0, 2.0}, kept);
  EXPECT_EQ(both.motions, kept.motions);
  DemandConflict conflict = conflictBetween(kept, both);
  EXPECT_EQ(conflict.motions, kept.motions) << "the kept motion leads in the forbidden direction";
  EXPECT_NE(toString(inWords(conflict).reason).find("'a'"), std::string::npos);
  EXPECT_TRUE(withoutEarlier(conflict, both).motions.empty());
  EXPECT_EQ(withoutEarlier(conflict, both).forbidden, both.forbidden);
  EXPECT_TRUE(conflictBetween(kept, withForbidden({"a"}, {1.0, 0.0, 0.0}, kept)).isNone());
  EXPECT_TRUE(conflictBetween(kept, withForbidden({"b"}, {0.0, 0.0, 1.0}, kept)).isNone());

  const SequenceDemands forbidden = withForbidden({"a"}, {0.0, 0.0, 1.0}, {});
  const SequenceDemands moved = withMotion({{"a"}, plan.steps[0].only().path, kByHand}, forbidden);
  EXPECT_EQ(moved.forbidden, forbidden.forbidden);
  conflict = conflictBetween(forbidden, moved);
  EXPECT_EQ(conflict.forbidden, forbidden.forbidden);
  EXPECT_EQ(withoutEarlier(conflict, moved).motions, moved.motions);

  const SequenceDemands first = withOrder({{"b"}, {"a"}}, {});
  const SequenceDemands turned = withOrder({{"a"}, {"b"}}, first);
  EXPECT_EQ(turned.before.size(), 2U);
  EXPECT_EQ(conflictBetween(first, turned).before, first.before);
  EXPECT_TRUE(conflictBetween(turned, turned).isNone()) << "what was there before is no new conflict";
}

TEST(DemandConflicts, ALockedStepTakesNoPlaceAway) {
  SequenceDemands demands;
  demands.places = {{{"stuck"}, 2}, {{"other"}, 3}};
  demands = withStepLocked(1, true, planOfSteps({"a", "b"}), demands);
  EXPECT_EQ(placesOf(demands), (Places{{"b", 2}, {"other", 3}, {"stuck", 4}}));
}

TEST(DemandConflicts, AMotionInAForbiddenDirectionIsNotPlanned) {
  const AssembledProduct product = test::lockedDrawer();
  SequenceDemands demands;
  demands.motions = {{{"cap"}, planOfSteps({"cap"}).steps[0].only().path, kByHand}};
  ASSERT_TRUE(resolved(demands, product).ok());
  demands.forbidden = {{"cap", {0.0, 0.1, 1.0}}};
  const auto refused = resolved(demands, product);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(toString(refused.error().reason).find("'cap'"), std::string::npos);
}

TEST(DemandedSteps, ADirectionIsForbiddenWithinThirtyDegrees) {
  const std::vector<Vector3> forbidden{Vector3::UnitZ()};
  EXPECT_TRUE(isForbidden({0.0, 0.5, 1.0}, forbidden));
  EXPECT_FALSE(isForbidden({0.0, 0.6, 1.0}, forbidden));
  EXPECT_FALSE(isForbidden({0.0, 0.0, -1.0}, forbidden));
}

/// Three boxes beside each other, free in every direction, beside a base.
AssembledProduct looseBoxes() {
  const auto box = [](const char* id, double x) {
    return boxBody(id, Vector3::Constant(0.1), Pose::translation({x, 0.0, 0.0}));
  };
  return test::productOf({boxBody("base", {2.0, 2.0, 0.1}, Pose::translation({0.0, 0.0, -0.2})), box("one", -0.5),
                          box("two", 0.0), box("three", 0.5)});
}

/// Plans without joints, because the tests are about demands.
AssemblyPlan planned(const AssembledProduct& product, const BodyId& staying, SequenceDemands demands,
                     const std::string& strategy = "greedy", const AssemblyPlan* known = nullptr) {
  const ProductFits fits = test::fitsOf(product);
  test::QuietHost host;
  BodySet stay(product.bodies.size(), false);
  stay[product.indexOf(staying)] = true;
  demands.jointUse = JointUse::Off;
  auto plan = planSequence(product, fits, {stay, strategy, 1, demands, nullptr, known}, host);
  EXPECT_TRUE(plan.ok()) << toString(plan.error());
  return *plan;
}

TEST(DemandedSteps, StepsComeAtTheirPlaces) {
  for (const char* strategy : {"greedy", "best-first"}) {
    SequenceDemands demands;
    demands.places = {{{"three"}, 1}, {{"one"}, 3}};
    const AssembledProduct product = looseBoxes();
    const AssemblyPlan plan = planned(product, "base", demands, strategy);
    EXPECT_EQ(test::orderOf(plan), (std::vector<BodyId>{"three", "two", "one"})) << strategy;
    EXPECT_EQ(plan.end, PlanEnd::Complete);
    const check::PlanVerdict judged = judgePlan(plan, product, std::nullopt);
    for (const check::StepVerdict& each : judged.steps) EXPECT_TRUE(each.valid()) << toString(each.againstDemand);
  }
}

TEST(DemandedSteps, AForcedStepSaysWhatItDoesNotKeepAndTheJudgeDemandsThatItDoes) {
  SequenceDemands demands;
  demands.places = {{{"three"}, 1}};
  demands.before = {{"one", "three"}};
  const AssembledProduct product = looseBoxes();
  AssemblyPlan plan = planned(product, "base", demands);
  ASSERT_EQ(test::orderOf(plan).front(), "three");
  ASSERT_EQ(plan.steps[0].violates.size(), 1U);
  EXPECT_EQ(plan.steps[0].violates[0].rule, StepViolation::Rule::Before);
  EXPECT_EQ(plan.steps[0].violates[0].bodies, std::vector<BodyId>{"one"});
  EXPECT_TRUE(judgePlan(plan, product, std::nullopt).steps[0].valid());
  plan.steps[0].violates.clear();
  const check::PlanVerdict judged = judgePlan(plan, product, std::nullopt);
  EXPECT_FALSE(judged.steps[0].valid());
  EXPECT_NE(toString(judged.steps[0].againstDemand).find("'one'"), std::string::npos);
}

TEST(DemandedSteps, WhatCannotBeProvedAtItsPlaceIsStuckWithItsBlockers) {
  SequenceDemands demands;
  demands.places = {{{"pin"}, 1}};
  const AssemblyPlan plan = planned(test::lockedDrawer(), "cabinet", demands);
  EXPECT_EQ(test::orderOf(plan), std::vector<BodyId>{"cap"}) << "nothing is forced, and nothing leaves through the pin";
  EXPECT_EQ(plan.end, PlanEnd::Stuck);
  ASSERT_EQ(plan.stuck.size(), 2U);
  const auto& pin = plan.stuck[0].body == "pin" ? plan.stuck[0] : plan.stuck[1];
  EXPECT_EQ(pin.body, "pin");
  EXPECT_EQ(toString(pin.reason), "no motion was found at the place that a constraint gives it");
  EXPECT_NE(std::find(pin.blockedBy.begin(), pin.blockedBy.end(), "cap"), pin.blockedBy.end()) << "it has left since";
}

TEST(DemandedSteps, APlaceBehindTheEndComesEarlyAndSaysSo) {
  SequenceDemands demands;
  demands.places = {{{"cap"}, 3}};
  const AssemblyPlan plan = planned(test::lockedDrawer(), "cabinet", demands);
  ASSERT_EQ(test::orderOf(plan), (std::vector<BodyId>{"cap", "pin", "drawer"}));
  ASSERT_EQ(plan.steps[0].violates.size(), 1U);
  EXPECT_EQ(plan.steps[0].violates[0].rule, StepViolation::Rule::Place);
}

TEST(DemandedSteps, NothingLeavesInAForbiddenDirection) {
  SequenceDemands demands;
  demands.forbidden = {{"two", Vector3::UnitZ()}, {"two", Vector3::UnitX()}};
  const AssembledProduct product = looseBoxes();
  const AssemblyPlan plan = planned(product, "base", demands);
  ASSERT_EQ(plan.steps.size(), 3U);
  for (const AssemblyStep& step : plan.steps) {
    if (step.only().body != "two") continue;
    const Vector3 way = exitDirection(step.only().path);
    EXPECT_LT(way.z(), tolerance::kForbiddenCone);
    EXPECT_LT(way.x(), tolerance::kForbiddenCone);
  }
  AssemblyPlan wrong = planned(product, "base", {});
  wrong.demands.forbidden = {{wrong.steps[0].only().body.text(), exitDirection(wrong.steps[0].only().path)}};
  EXPECT_FALSE(judgePlan(wrong, product, std::nullopt).steps[0].valid());
}

/// A block in a pit whose walls are 0.02 m from it on each side; one wall is lower, or is missing at +x. Over the lower
/// wall the block moves within 30 degrees of +z.
AssembledProduct blockInAPit(double lowerWall) {
  std::vector<test::Piece> pieces{{{1.0, 1.0, 0.1}, {0.0, 0.0, -0.05}},
                                  {{0.1, 1.0, 0.5}, {-0.22, 0.0, 0.25}},
                                  {{1.0, 0.1, 0.5}, {0.0, -0.22, 0.25}},
                                  {{1.0, 0.1, 0.5}, {0.0, 0.22, 0.25}}};
  if (lowerWall > 0.0) pieces.push_back({{0.1, 1.0, lowerWall}, {0.22, 0.0, 0.5 * lowerWall}});
  return test::productOf(
      {test::bodyOf("pit", pieces), boxBody("block", {0.3, 0.3, 0.3}, Pose::translation({0.0, 0.0, 0.15 + 1e-5}))});
}

/// A block that leaves upwards first and then aside leaves upwards.
TEST(DemandedSteps, ADirectionIsForbiddenUntilThePartHasLeftWhatItTouched) {
  SequenceDemands demands;
  demands.forbidden = {{"block", Vector3::UnitZ()}};
  const AssembledProduct closed = blockInAPit(0.2);
  EXPECT_EQ(planned(closed, "pit", {}).steps.size(), 1U);
  for (const char* strategy : {"greedy", "best-first"}) {
    const AssemblyPlan stuck = planned(closed, "pit", demands, strategy);
    EXPECT_TRUE(stuck.steps.empty());
    ASSERT_EQ(stuck.stuck.size(), 1U);
    EXPECT_NE(toString(stuck.stuck[0].reason).find("ruled out"), std::string::npos) << toString(stuck.stuck[0].reason);
  }
  const AssembledProduct open = blockInAPit(0.0);
  const AssemblyPlan plan = planned(open, "pit", demands);
  ASSERT_EQ(plan.steps.size(), 1U);
  EXPECT_LT(plan.steps[0].only().path[1].q.position.z(), 0.16);
  EXPECT_TRUE(judgePlan(plan, open, std::nullopt).valid());
}

/// A motion of a person is judged by the same rule, and so is one that a plan states.
TEST(DemandedSteps, AMotionUpwardsAndThenAsideIsRefused) {
  const AssembledProduct open = blockInAPit(0.0);
  const Pose start = open.bodies[1].X_WB;
  const auto through = [&](const Vector3& way) { return Pose{start.position + way, start.orientation}; };
  const auto plans = [&](const Vector3& first, const Vector3& second) {
    SequenceDemands demands;
    demands.motions = {
        {{"block"},
         {{start, Author::Operator}, {through(first), Author::Operator}, {through(second), Author::Operator}},
         kByHand}};
    AssemblyPlan plan = planned(open, "pit", demands);
    EXPECT_EQ(plan.steps.size(), 1U);
    plan.demands.forbidden = {{"block", Vector3::UnitZ()}};
    const bool valid = judgePlan(plan, open, std::nullopt).valid();
    demands.forbidden = {{"block", Vector3::UnitZ()}};
    const auto rules = resolved(demands, open);
    const bool found = rules.ok() && !planned(open, "pit", demands).steps.empty();
    EXPECT_EQ(found, valid);
    return valid;
  };
  EXPECT_FALSE(plans({0.0, 0.0, 0.8}, {2.0, 0.0, 0.8}));
  EXPECT_FALSE(plans({0.05, 0.0, 0.0}, {0.05, 0.0, 2.0}));
  EXPECT_TRUE(plans({1.0, 0.0, 0.0}, {1.0, 0.0, 2.0}));
}

TEST(DemandedSteps, AMotionOfAPersonIsTheOnlyOne) {
  const AssembledProduct product = looseBoxes();
  const RigidBody& two = product.bodies[product.indexOf("two")];
  Pose aside = two.X_WB;
  aside.position += Vector3(0.0, 3.0, 0.0);
  SequenceDemands demands;
  demands.motions = {{{"two"}, {{two.X_WB, Author::Operator}, {aside, Author::Operator}}, kByHand}};
  const AssemblyPlan plan = planned(product, "base", demands);
  ASSERT_EQ(plan.steps.size(), 3U);
  const auto own =
      std::find_if(plan.steps.begin(), plan.steps.end(), [](const auto& step) { return step.only().body == "two"; });
  EXPECT_EQ(own->only().method, kByHand);
  EXPECT_EQ(own->only().path.back().q, aside);

  Pose through = two.X_WB;
  through.position += Vector3(3.0, 0.0, 0.0);
  demands.motions[0].path.back().q = through;
  demands.places = {{{"two"}, 1}};
  const AssemblyPlan blocked = planned(product, "base", demands);
  ASSERT_EQ(blocked.stuck.size(), 1U) << "there is a free motion, but not this one";
  EXPECT_EQ(blocked.stuck[0].blockedBy, std::vector<BodyId>{"three"});
}

/// Refuses every removal, but certifies every motion.
class CertifyingTrial final : public RemovalTrial {
 public:
  int efforts() const override { return 2; }
  RemovalAnswer tryRemoval(const BodyGroup&, const BodySet&, int effort, const StopToken&) override {
    searches += effort;
    return Refused{};
  }
  std::vector<BodyGroup> groupsAlongLines(const GroupQuestion&, ThreadTeam&, const StopToken&) override { return {}; }
  std::vector<std::size_t> inTheWay(const BodyGroup&, const std::vector<PathPoint>&, const std::vector<std::size_t>&,
                                    const StopToken&) override {
    return {};
  }
  std::optional<Removed> certified(const BodyGroup&, const std::vector<PathPoint>& path, const std::string& method,
                                   const BodySet&, const StopToken&) override {
    return Removed{{path, {}}, method, {}};
  }
  void learn(const BodyGroup&, const std::vector<PathPoint>&) override {}

  int searches = 0;
};

TEST(DemandedSteps, AKnownMotionIsNotSearchedAgain) {
  const AssembledProduct product = looseBoxes();
  AssemblyPlan known = planOfSteps({"two"});
  known.steps[0].only().path[0].q = product.bodies[2].X_WB;
  known.steps[0].only().path[1].q.position = {0.0, 0.0, 9.0};
  known.steps[0].only().method = "auto: known";
  CertifyingTrial inner;
  OrderRules rules;
  DemandingTrial trial(inner, rules, product, &known);
  const BodySet all(product.bodies.size(), true);
  EXPECT_TRUE(std::holds_alternative<Removed>(trial.tryRemoval({2}, all, 1, {})));
  EXPECT_EQ(inner.searches, 0);
  EXPECT_TRUE(std::holds_alternative<Refused>(trial.tryRemoval({3}, all, 1, {})));
  EXPECT_EQ(inner.searches, 1);
}

TEST(DemandedSteps, DemandsThatContradictEachOtherAreErrors) {
  const AssembledProduct product = looseBoxes();
  const auto reasonOf = [&](const SequenceDemands& demands) {
    const auto rules = resolved(demands, product);
    return rules ? std::string() : toString(rules.error().reason);
  };
  SequenceDemands demands;
  demands.places = {{{"one"}, 1}, {{"two"}, 1}};
  EXPECT_EQ(reasonOf(demands), "two steps are constrained to place 1");
  demands.places = {{{"one"}, 1}, {{"one"}, 2}};
  EXPECT_EQ(reasonOf(demands), "'one' is constrained to two places");
  demands.places = {{{"one", "two"}, 1}, {{"two", "three"}, 2}};
  EXPECT_EQ(reasonOf(demands), "'two' is in two constrained steps or groups");
  demands.places = {{{"moon"}, 1}};
  EXPECT_NE(reasonOf(demands).find("'moon'"), std::string::npos);
  demands = {};
  demands.forbidden = {{"one", Vector3::Zero()}};
  EXPECT_NE(reasonOf(demands).find("no length"), std::string::npos);
  demands = {};
  demands.motions = {{{"one"}, {{Pose::identity(), Author::Operator}}, kByHand}};
  EXPECT_EQ(reasonOf(demands), "a motion of a constraint has fewer than two configurations");
}

}  // namespace
}  // namespace glissade
