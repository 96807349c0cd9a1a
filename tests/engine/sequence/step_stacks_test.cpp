#include "engine/sequence/step_stacks.h"

#include <gtest/gtest.h>

#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

/// Certifies every motion, or none; keeps the bodies that were there.
class StackTrial final : public RemovalTrial {
 public:
  int efforts() const override { return 1; }
  RemovalAnswer tryRemoval(const BodyGroup&, const BodySet&, int, const StopToken&) override { return Refused{}; }
  std::vector<BodyGroup> groupsAlongLines(const GroupQuestion&, ThreadTeam&, const StopToken&) override { return {}; }
  std::vector<std::size_t> inTheWay(const BodyGroup&, const std::vector<PathPoint>&, const std::vector<std::size_t>&,
                                    const StopToken&) override {
    return {};
  }
  std::optional<Removed> certified(const BodyGroup&, const std::vector<PathPoint>& path, const std::string& method,
                                   const BodySet& present, const StopToken&) override {
    asked.push_back(bodiesIn(present));
    if (!certifies) return std::nullopt;
    return Removed{{path, {}}, method, {}};
  }
  void learn(const BodyGroup&, const std::vector<PathPoint>&) override {}

  bool certifies = true;
  std::vector<BodyGroup> asked;
};

Joint nutOn(std::size_t nut, std::size_t bolt) {
  Joint joint;
  joint.kind = JointKind::Nut;
  joint.body = nut;
  joint.others = {bolt};
  joint.clamped = {1};
  return joint;
}

/// A cover on a base with two bolts and their nuts, and a lid. Bodies by index: base, cover, nut1, bolt1, nut2, bolt2,
/// lid.
class StepStacks : public testing::Test {
 protected:
  AssembledProduct product =
      test::productOf({boxBody("base", Vector3::Constant(0.1), {}), boxBody("cover", Vector3::Constant(0.1), {}),
                       boxBody("nut1", Vector3::Constant(0.1), {}), boxBody("bolt1", Vector3::Constant(0.1), {}),
                       boxBody("nut2", Vector3::Constant(0.1), {}), boxBody("bolt2", Vector3::Constant(0.1), {}),
                       boxBody("lid", Vector3::Constant(0.1), {})});
  JointRules joints{{nutOn(2, 3), nutOn(4, 5)}, product, std::vector<FastenerKind>(7, FastenerKind::None)};
  StackTrial trial;
  SequenceQuestion question{product, BodySet(7, false), 1, trial, nullptr, {}, {}, nullptr, {}, {}, nullptr, &joints};
  AssemblyPlan plan = found();

  static AssemblyStep stepOf(const BodyId& body, std::size_t wave, std::size_t afterSteps,
                             const std::vector<std::size_t>& after) {
    StepMotion motion;
    motion.body = body;
    motion.path = {{Pose::identity()}, {Pose::translation({0.0, 0.0, 1.0})}};
    motion.proof.afterSteps = afterSteps;
    motion.proof.nearest = "base";
    return {{motion}, wave, after};
  }

  /// The plan as a search has found it.
  static AssemblyPlan found() {
    AssemblyPlan plan;
    plan.steps = {stepOf("lid", 1, 0, {}),  stepOf("nut1", 2, 1, {1}),  stepOf("bolt1", 3, 2, {2}),
                  stepOf("nut2", 3, 0, {}), stepOf("bolt2", 5, 2, {4}), stepOf("cover", 6, 5, {3, 5})};
    for (std::size_t i = 1; i < 5; ++i) plan.steps[i].task = 2;
    plan.refusals = {{"cover", 0, 2, {"bolt1"}}};
    plan.waiting = {plan.steps[5].only()};
    plan.lines = {{6, {"cover"}}};
    return plan;
  }

  AssemblyPlan joined() {
    joinStacks(plan, question, {});
    return plan;
  }
};

using Numbers = std::vector<std::size_t>;

TEST_F(StepStacks, NutAndBoltAreOneStep) {
  const AssemblyPlan plan = joined();
  ASSERT_EQ(plan.steps.size(), 4U);
  EXPECT_EQ(plan.steps[1].bodies(), (std::vector<BodyId>{"nut1", "bolt1"}));
  EXPECT_EQ(plan.steps[2].bodies(), (std::vector<BodyId>{"nut2", "bolt2"}));
  EXPECT_EQ(plan.removed(), 6U);
  EXPECT_TRUE(trial.asked.empty()) << "all proofs hold";
}

TEST_F(StepStacks, NumbersOfStepsFollow) {
  const AssemblyPlan plan = joined();
  EXPECT_EQ(plan.steps[1].after, Numbers{1});
  EXPECT_EQ(plan.steps[2].after, Numbers{});
  EXPECT_EQ(plan.steps[3].after, (Numbers{2, 3}));
  EXPECT_EQ(plan.steps[3].wave, 4U);
  EXPECT_EQ(plan.steps[1].task, 1U);
  EXPECT_EQ(plan.steps[2].task, 1U);
  EXPECT_EQ(plan.refusals[0].afterSteps, 2U) << "a stack that had begun counts as a whole";
  EXPECT_EQ(plan.waiting[0].proof.afterSteps, 3U);
  EXPECT_EQ(plan.lines[0].step, 4U);
}

TEST_F(StepStacks, NoProofClaimsABodyThatWasNotThere) {
  const AssemblyPlan plan = joined();
  EXPECT_EQ(plan.steps[1].motions[1].proof.afterSteps, 1U) << "its own nut counts as left in any case";
  EXPECT_EQ(plan.steps[2].motions[0].proof.afterSteps, 0U);
  EXPECT_EQ(plan.steps[2].motions[1].proof.afterSteps, 2U) << "nut1 had left, so bolt1 is not claimed";
}

/// bolt2 was proved beside bolt1, which its step no longer claims.
TEST_F(StepStacks, AProofWithoutItsNearestBodyIsMadeAgain) {
  plan.steps[4].only().proof.nearest = "bolt1";
  const AssemblyPlan again = joined();
  ASSERT_EQ(again.steps.size(), 4U);
  EXPECT_EQ(trial.asked, std::vector<BodyGroup>({{0, 1, 5}}));
  EXPECT_EQ(again.steps[2].motions[1].proof.afterSteps, 2U);
  EXPECT_TRUE(again.steps[2].motions[1].proof.nearest.empty());
}

TEST_F(StepStacks, APlanStaysAsItIsWhereAProofCannotBeMadeAgain) {
  plan.steps[4].only().proof.nearest = "bolt1";
  trial.certifies = false;
  EXPECT_EQ(joined().steps.size(), 6U);
  EXPECT_EQ(plan.refusals[0].afterSteps, 2U);
  EXPECT_EQ(plan.lines[0].step, 6U);
}

/// The step of bolt1 is after the lid, because the one of its nut is.
TEST_F(StepStacks, NothingIsAllowedAgainstWhatHasLeftInEveryOrder) {
  for (const BodyId& other : {BodyId("base"), BodyId("lid"), BodyId("nut1")}) {
    plan.steps[2].only().allowances.emplace_back().body = other;
  }
  const AssemblyPlan one = joined();
  const std::vector<Allowance>& left = one.steps[1].motions[1].allowances;
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].body, "base");
}

TEST_F(StepStacks, OnlyMotionsThatFollowEachOtherAreJoined) {
  std::swap(plan.steps[2], plan.steps[3]);
  plan.steps[5].after = {4, 5};
  plan.steps[4].after = {3};
  plan.steps[3].after = {2};
  plan.steps[2].only().proof.afterSteps = plan.steps[3].only().proof.afterSteps = 1;
  EXPECT_EQ(joined().steps.size(), 6U) << "nut1, nut2, bolt1, bolt2";
  plan = found();
  question.joints = nullptr;
  EXPECT_EQ(joined().steps.size(), 6U);
}

TEST_F(StepStacks, ATaskOfOneStepIsNone) {
  for (std::size_t i = 3; i < 5; ++i) plan.steps[i].task = 0;
  for (const AssemblyStep& step : joined().steps) EXPECT_EQ(step.task, 0U);
}

TEST_F(StepStacks, ASearchResumesWithAStepForEachMotion) {
  const AssemblyPlan split = splitStacks(joined());
  EXPECT_EQ(test::orderOf(split), test::orderOf(found()));
  ASSERT_EQ(split.steps.size(), 6U);
  EXPECT_EQ(split.steps[2].only().proof.afterSteps, 2U);
  EXPECT_EQ(split.steps[5].only().proof.afterSteps, 5U);
  EXPECT_EQ(split.refusals[0].afterSteps, 3U);
}

}  // namespace
}  // namespace glissade
