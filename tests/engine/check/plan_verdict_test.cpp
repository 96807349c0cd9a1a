#include "engine/check/plan_verdict.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/check/read_path.h"
#include "engine/check/verdict_report.h"
#include "engine/files/judged_product.h"
#include "engine/files/plan_file.h"
#include "engine/planning/screw_motion.h"
#include "tests/engine/fits/screwed_parts.h"
#include "tests/engine/sequence/products.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

std::string whyNot(const check::PlanVerdict& verdict, const AssembledProduct& product) {
  return check::reportText(verdict, judgedProduct(product));
}

TEST(PlanVerdict, AgreesWithThePlanner) {
  const AssembledProduct product = test::lockedDrawer();
  const AssemblyPlan plan = test::planOf(product, "cabinet");
  ASSERT_EQ(test::orderOf(plan), (std::vector<BodyId>{"cap", "pin", "drawer"}));
  const check::PlanVerdict verdict = judgePlan(plan, product, std::nullopt);
  EXPECT_EQ(verdict.steps.size(), 3U);
  EXPECT_TRUE(verdict.valid()) << whyNot(verdict, product);
}

TEST(PlanVerdict, RefusesAnOrderThatIsNotFree) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyPlan plan = test::planOf(product, "cabinet");
  ASSERT_EQ(plan.steps.size(), 3U);
  std::swap(plan.steps[1], plan.steps[2]);
  const check::PlanVerdict verdict = judgePlan(plan, product, std::nullopt);
  EXPECT_TRUE(verdict.steps[0].valid());
  EXPECT_FALSE(verdict.steps[1].valid()) << "the drawer through its pin";
  EXPECT_EQ(verdict.steps[1].motion.verdict.nearest.body, static_cast<int>(product.indexOf("pin")));
}

/// A body may be there if the step does not have to come after its removal.
TEST(PlanVerdict, RefusesAPrecedenceThatLeavesSomethingOut) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyPlan plan = test::planOf(product, "cabinet");
  ASSERT_EQ(plan.steps.size(), 3U);
  EXPECT_EQ(plan.steps[1].after, std::vector<std::size_t>{1});
  plan.steps[1].after.clear();
  const check::PlanVerdict verdict = judgePlan(plan, product, std::nullopt);
  EXPECT_TRUE(verdict.steps[0].valid());
  EXPECT_FALSE(verdict.steps[1].valid()) << "the pin under its cap";
}

/// Cap, pin and drawer in one step: each motion comes after the earlier ones of its step.
TEST(PlanVerdict, JudgesEachMotionOfAStepAndNamesIt) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyPlan plan = test::planOf(product, "cabinet");
  ASSERT_EQ(plan.steps.size(), 3U);
  AssemblyStep one{{}, 1};
  for (AssemblyStep& step : plan.steps) {
    one.motions.push_back(step.only());
    one.motions.back().proof.afterSteps = 0;
  }
  plan.steps = {one};
  const check::PlanVerdict verdict = judgePlan(plan, product, std::nullopt);
  EXPECT_TRUE(verdict.valid()) << whyNot(verdict, product);
  EXPECT_EQ(verdict.validSteps(), 1U);
  EXPECT_EQ(verdict.steps.size(), 3U);
  EXPECT_EQ(verdict.alone, 3U);
  EXPECT_NE(whyNot(verdict, product).find("1 of 1 step is certified"), std::string::npos) << whyNot(verdict, product);

  std::swap(plan.steps[0].motions[1], plan.steps[0].motions[2]);
  const check::PlanVerdict swapped = judgePlan(plan, product, std::nullopt);
  EXPECT_FALSE(swapped.isValid(1));
  EXPECT_EQ(swapped.validSteps(), 0U);
  EXPECT_TRUE(swapped.steps[0].valid());
  const std::string why = whyNot(swapped, product);
  EXPECT_NE(why.find("step 1, motion 2 (drawer) is invalid: "), std::string::npos) << why;
}

/// In version 1 the keys of the motion were keys of the step.
TEST(PlanVerdict, ReadsPlansOfBothVersions) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyPlan plan = test::planOf(product, "cabinet");
  ASSERT_EQ(plan.steps.size(), 3U);
  nlohmann::ordered_json old = planJson(plan, "drawer");
  old["version"] = 1;
  for (auto& step : old["steps"]) {
    step.update(nlohmann::ordered_json(step["motions"][0]));
    step.erase("motions");
  }
  plan.steps[0].motions.push_back(plan.steps[1].only());
  plan.steps.erase(plan.steps.begin() + 1);
  plan.steps[1].after = {1};
  plan.steps[0].motions[1].proof.afterSteps = 0;
  plan.steps[1].only().proof.afterSteps = 1;
  const test::TemporaryFolder folder;
  const auto read = [&](const nlohmann::ordered_json& json) {
    const std::string file = folder / "plan.json";
    std::ofstream(file) << json;
    return check::readPlan(file);
  };
  const auto ofVersion1 = read(old);
  ASSERT_TRUE(ofVersion1.ok()) << toString(ofVersion1.error());
  ASSERT_EQ(ofVersion1->steps.size(), 3U);
  EXPECT_EQ(ofVersion1->steps[2].number, 3U);
  EXPECT_EQ(ofVersion1->steps[2].motion, 0U);
  const auto ofVersion2 = read(planJson(plan, "drawer"));
  ASSERT_TRUE(ofVersion2.ok()) << toString(ofVersion2.error());
  ASSERT_EQ(ofVersion2->steps.size(), 3U);
  EXPECT_EQ(ofVersion2->steps[1].number, 1U);
  EXPECT_EQ(ofVersion2->steps[1].motion, 2U);
  EXPECT_EQ(ofVersion2->steps[2].number, 2U);
  for (const auto* each : {&*ofVersion1, &*ofVersion2}) {
    const check::PlanVerdict verdict = check::judgePlan(judgedProduct(product), *each, std::nullopt);
    EXPECT_TRUE(verdict.valid()) << whyNot(verdict, product);
  }
  old["version"] = 3;
  EXPECT_FALSE(read(old).ok());
}

TEST(PlanVerdict, RefusesAPathThatEndsInsideAndAllowancesOfItsOwn) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyPlan plan = test::planOf(product, "cabinet");
  ASSERT_EQ(plan.steps.size(), 3U);
  plan.steps[0].only().path.pop_back();
  plan.steps[1].only().allowances.push_back({"cabinet", ContactKind::Planar, 0.0, 1e-3, {}});
  const check::PlanVerdict verdict = judgePlan(plan, product, std::nullopt);
  EXPECT_FALSE(verdict.steps[0].endsOutside);
  ASSERT_FALSE(verdict.steps[1].refusals.empty());
  EXPECT_NE(toString(verdict.steps[1].refusals[0]).find("1 mm of 'pin' on 'cabinet'"), std::string::npos);
  EXPECT_TRUE(verdict.steps[2].valid());
}

/// The cap leaves first, so the drawer is never compared with it.
TEST(PlanVerdict, RefusesAnAllowanceAgainstWhatHasLeft) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyPlan plan = test::planOf(product, "cabinet");
  ASSERT_EQ(plan.steps.size(), 3U);
  plan.steps[2].only().allowances.push_back({"cap", ContactKind::Planar, 0.0, 1e-3, {}});
  const check::PlanVerdict verdict = judgePlan(plan, product, std::nullopt);
  ASSERT_FALSE(verdict.steps[2].refusals.empty());
  EXPECT_NE(toString(verdict.steps[2].refusals[0]).find("1 mm of 'drawer' on 'cap'"), std::string::npos);
}

/// Two blocks side by side on a base: the second one is proved beside the first, which may leave later in another
/// order.
TEST(PlanVerdict, ReportsNoAllowanceAgainstWhatHasLeft) {
  const AssembledProduct product =
      test::productOf({boxBody("base", {0.3, 0.1, 0.1}, Pose::identity()),
                       boxBody("left", {0.1, 0.1, 0.1}, Pose::translation({-0.05, 0.0, 0.1})),
                       boxBody("right", {0.1, 0.1, 0.1}, Pose::translation({0.05, 0.0, 0.1}))},
                      true);
  const AssemblyPlan plan = test::planOf(product, "base");
  ASSERT_EQ(plan.steps.size(), 2U);
  const check::PlanVerdict verdict = judgePlan(plan, product, std::nullopt);
  EXPECT_TRUE(verdict.valid()) << whyNot(verdict, product);
  const auto& judged = verdict.steps[1].allowances;
  EXPECT_TRUE(std::any_of(judged.begin(), judged.end(),
                          [&](const auto& each) { return each.other == plan.steps[0].only().body; }));
  const std::string text = check::reportText(verdict, judgedProduct(product));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("step 1: allowance") == std::string::npos) continue;
    EXPECT_EQ(line.find("'" + plan.steps[0].only().body.text() + "'"), std::string::npos) << line;
  }
  EXPECT_NE(text.find("step 1: allowance"), std::string::npos) << "against the base";
}

/// A demand that the judge cannot read is not ignored.
TEST(PlanVerdict, RefusesADemandAboutNothing) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyPlan plan = test::planOf(product, "cabinet");
  plan.demands.before = {{"cap", "pin"}};
  EXPECT_TRUE(judgePlan(plan, product, std::nullopt).valid());
  plan.demands.before.emplace_back("ca", "pin");
  const check::PlanVerdict verdict = judgePlan(plan, product, std::nullopt);
  EXPECT_FALSE(verdict.valid());
  ASSERT_EQ(verdict.refusals.size(), 1U);
  EXPECT_NE(toString(verdict.refusals[0]).find("'ca'"), std::string::npos);
}

/// A plate on a bolt with a nut on either side of it, both pairs marked as threads.
AssembledProduct boltedPlate() {
  AssembledProduct product =
      test::productOf({test::partAt("plate", test::makeRing(0.006, 0.05, 0.006, 40), Pose::identity()),
                       test::partAt("bolt", test::plainBolt(), Pose::identity()),
                       test::partAt("nut", test::hexNut(), Pose::translation({0.0, 0.0, 0.0075})),
                       test::partAt("nut#2", test::hexNut(), Pose::translation({0.0, 0.0, -0.0075}))},
                      true);
  product.fits.pairs = {{"nut", "bolt", ContactKind::Thread, {}, false},
                        {"bolt", "nut#2", ContactKind::Thread, {}, false}};
  return product;
}

TEST(PlanVerdict, NutsLeaveTheirBoltFirstAndByTurningOnly) {
  const AssembledProduct product = boltedPlate();
  const AssemblyPlan plan = test::planOf(product, "plate");
  ASSERT_EQ(test::orderOf(plan), (std::vector<BodyId>{"nut", "nut#2", "bolt"}));
  EXPECT_EQ(plan.steps[0].only().method, "turned");
  ASSERT_EQ(plan.steps[0].only().allowances.size(), 1U);
  EXPECT_EQ(plan.steps[0].only().allowances[0].pitch, test::kCoarsePitch);
  EXPECT_NEAR(plan.steps[0].only().allowances[0].turns, 0.0115 / test::kCoarsePitch, 0.1);
  EXPECT_EQ(plan.steps[2].only().method, "straight");
  const check::PlanVerdict turned = judgePlan(plan, product, std::nullopt);
  EXPECT_TRUE(turned.valid()) << whyNot(turned, product);

  AssemblyPlan pulling = plan;
  pulling.steps[0].only().path = {plan.steps[0].only().path.front(), plan.steps[0].only().path.back()};
  const check::PlanVerdict verdict = judgePlan(pulling, product, std::nullopt);
  EXPECT_FALSE(verdict.steps[0].valid());
  EXPECT_TRUE(verdict.steps[0].motion.verdict.againstThread);
  EXPECT_EQ(verdict.steps[0].motion.verdict.nearest.body, static_cast<int>(product.indexOf("bolt")));
}

/// Nobody marks a thread and the cylinders are equal: the step's joint states that there is a thread.
/// Names and shapes show that a nut is on a thread, whatever the plan says.
TEST(PlanVerdict, ANutIsOnAThread) {
  AssembledProduct product = boltedPlate();
  product.fits.pairs.clear();
  const AssemblyPlan plan = test::planOf(product, "plate");
  ASSERT_EQ(plan.steps[0].only().method, "straight");
  const check::StepVerdict step = judgePlan(plan, product, std::nullopt).steps[0];
  EXPECT_FALSE(step.pulls.empty() && step.refusals.empty());
}

TEST(PlanVerdict, AJointOfTheStepIsAThread) {
  const TriangleMesh collar = test::makeRing(test::kBoltRadius, 0.009, test::kNutLength, 48);
  const AssembledProduct product =
      test::productOf({test::partAt("plate", test::makeRing(0.006, 0.05, 0.006, 40), Pose::identity()),
                       test::partAt("bolt", test::plainBolt(), Pose::identity()),
                       test::partAt("collar", collar, Pose::translation({0.0, 0.0, 0.0075}))},
                      true);
  AssemblyPlan plan = test::planOf(product, "plate");
  ASSERT_EQ(plan.steps[0].only().method, "straight");
  const auto isReported = [&] {
    const check::StepVerdict step = judgePlan(plan, product, std::nullopt).steps[0];
    return !step.pulls.empty() || !step.refusals.empty();
  };
  EXPECT_FALSE(isReported());
  const BodyId other(plan.steps[0].only().body == "bolt" ? "collar" : "bolt");
  plan.steps[0].only().joints = {{JointKind::Pin, plan.steps[0].only().body, {other}}};
  EXPECT_FALSE(isReported());
  for (const JointKind kind : {JointKind::Nut, JointKind::Screw, JointKind::Thread}) {
    plan.steps[0].only().joints = {{kind, plan.steps[0].only().body, {other}}};
    EXPECT_TRUE(isReported());
    plan.steps[0].only().joints = {{kind, other, {plan.steps[0].only().body}}};
    EXPECT_TRUE(isReported());
  }
}

/// A nut on a bolt that stays, and a cap that leaves together with the nut.
TEST(PlanVerdict, AGroupWithANutLeavesTheBoltByTurningOnly) {
  AssembledProduct product = test::productOf(
      {test::partAt("bolt", test::plainBolt(), Pose::identity()),
       test::partAt("nut", test::hexNut(), Pose::translation({0.0, 0.0, 0.0075})),
       test::partAt("cap", test::makeRing(0.006, 0.009, 0.004, 40), Pose::translation({0.0, 0.0, 0.0137}))},
      true);
  product.fits.pairs = {{"nut", "bolt", ContactKind::Thread, {}, false}};
  const ProductFits fits = test::fitsOf(product);
  MotionTrial trial(product, fits, 1, 0);
  test::QuietHost host;
  SequenceQuestion question{product, {true, false, false}, 1, trial};
  question.rules.together = {{1, 2}};
  const AssemblyPlan plan = makeSequenceStrategyRegistry().find("greedy")->make()->plan(question, host);
  ASSERT_EQ(plan.steps.size(), 1U);
  EXPECT_EQ(plan.steps[0].bodies(), (std::vector<BodyId>{"nut", "cap"}));
  EXPECT_EQ(plan.steps[0].only().method, "turned");
  ASSERT_EQ(plan.steps[0].only().allowances.size(), 1U);
  EXPECT_EQ(plan.steps[0].only().allowances[0].pitch, test::kCoarsePitch);
  EXPECT_GT(plan.steps[0].only().allowances[0].turns, 7.0);
  const check::PlanVerdict turned = judgePlan(plan, product, std::nullopt);
  EXPECT_TRUE(turned.valid()) << whyNot(turned, product);

  AssemblyPlan pulling = plan;
  pulling.steps[0].only().path = {plan.steps[0].only().path.front(), plan.steps[0].only().path.back()};
  pulling.steps[0].only().path.back().q.orientation = pulling.steps[0].only().path.front().q.orientation;
  const check::PlanVerdict verdict = judgePlan(pulling, product, std::nullopt);
  EXPECT_FALSE(verdict.steps[0].valid());
  EXPECT_TRUE(verdict.steps[0].motion.verdict.againstThread);
}

/// A drawer and a pin on it, which leave the cabinet together, and are then taken apart.
struct PlanOfLines : ::testing::Test {
  AssembledProduct product =
      test::productOf({test::partAt("cabinet", makeBox({0.2, 0.2, 0.02}), Pose::identity()),
                       test::partAt("drawer", makeBox({0.1, 0.1, 0.02}), Pose::translation({0.0, 0.0, 0.0201})),
                       test::partAt("pin", makeBox({0.01, 0.01, 0.02}), Pose::translation({0.0, 0.0, 0.0402}))},
                      false);
  AssemblyPlan plan;

  PlanOfLines() {
    plan.bodies = {"cabinet", "drawer", "pin"};
    plan.staying = {"cabinet"};
    plan.steps = {straight({"drawer", "pin"}, {0.0, 0.0, 0.3})};
    plan.lines = {{1, {"drawer", "pin"}, {"drawer"}, {straight({"pin"}, {0.0, 0.0, 0.2})}, {}, {}}};
  }

  static AssemblyStep straight(const std::vector<BodyId>& bodies, const Vector3& way) {
    AssemblyStep step{{StepMotion()}};
    step.only().body = bodies.front();
    step.only().with.assign(bodies.begin() + 1, bodies.end());
    step.only().path = computedPoints({Pose::identity(), Pose::translation(way)});
    return step;
  }
  check::PlanVerdict verdict() const { return judgePlan(plan, product, std::nullopt); }
};

TEST_F(PlanOfLines, IsJudgedAmongTheBodiesOfTheGroup) {
  const check::PlanVerdict judged = verdict();
  EXPECT_TRUE(judged.valid()) << whyNot(judged, product);
  ASSERT_EQ(judged.lines.size(), 1U);
  EXPECT_EQ(judged.lines[0].line, std::vector<std::size_t>{1});
  EXPECT_EQ(judged.lines[0].steps.size(), 1U);

  plan.lines[0].steps[0] = straight({"pin"}, {0.0, 0.0, -0.3});
  EXPECT_FALSE(verdict().valid()) << "through the drawer";
  plan.lines[0].steps[0] = straight({"cabinet"}, {0.0, 0.0, -0.3});
  EXPECT_FALSE(verdict().valid()) << "it is not in the group";
}

TEST_F(PlanOfLines, RefusesALineThatIsNotThatOfItsStep) {
  const SubassemblyLine line = plan.lines[0];
  plan.lines[0].step = 2;
  EXPECT_FALSE(verdict().valid());
  plan.lines = {line, line};
  EXPECT_FALSE(verdict().valid()) << "two lines of one step";
  plan.lines = {line};
  plan.lines[0].bodies.push_back("cabinet");
  EXPECT_FALSE(verdict().valid());
  plan.lines[0] = line;
  plan.lines[0].staying = {"cabinet"};
  EXPECT_FALSE(verdict().valid());
  plan.lines[0] = line;
  plan.lines[0].staying.push_back("pin");
  EXPECT_FALSE(verdict().valid()) << "the pin stays";
}

/// A forbidden direction also holds in lines.
TEST_F(PlanOfLines, KeepsForbiddenDirections) {
  plan.demands.forbidden = {{"pin", Vector3::UnitZ()}};
  plan.steps[0] = straight({"drawer", "pin"}, {0.3, 0.0, 0.0});
  const check::PlanVerdict judged = verdict();
  EXPECT_TRUE(judged.steps[0].valid()) << whyNot(judged, product);
  EXPECT_FALSE(judged.lines[0].steps[0].againstDemand.empty());
}

TEST_F(PlanOfLines, CountsFlexibleBodiesWithoutAProof) {
  AssemblyStep& belt = plan.lines[0].steps[0];
  belt.only().certified = false;
  EXPECT_FALSE(verdict().valid()) << "its body is not flexible";
  belt.only().joints.emplace_back().kind = JointKind::Flexible;
  belt.only().joints[0].body = "pin";
  const check::PlanVerdict judged = verdict();
  EXPECT_TRUE(judged.valid()) << whyNot(judged, product);
  EXPECT_EQ(judged.stepsWithoutProof(), 1U);
  EXPECT_EQ(judged.validSteps(), 1U);
  EXPECT_NE(whyNot(judged, product).find("step 1.1 (pin): its motion has no certificate"), std::string::npos);

  belt.only().certified = true;
  EXPECT_FALSE(verdict().valid()) << "a flexible body cannot be certified";
  belt.only().certified = false;
  plan.steps[0].only().certified = false;
  plan.steps[0].only().joints = belt.only().joints;
  EXPECT_FALSE(verdict().valid()) << "a flexible body takes nothing with it";
}

}  // namespace
}  // namespace glissade
