// Statements and numbers of a plan: a statement on which a verdict depends is a condition, a wrong one is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "engine/check/standard_pitch.h"
#include "engine/check/verdict_report.h"
#include "engine/files/judged_product.h"
#include "engine/planning/screw_motion.h"
#include "engine/sequence/sequence_run.h"
#include "tests/engine/fits/screwed_parts.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

using check::PlanOutcome;
using testing::ElementsAre;
using testing::HasSubstr;

/// A drawer with a pin on it, on a cabinet.
struct PlanOfWords : ::testing::Test {
  AssembledProduct product =
      test::productOf({test::partAt("cabinet", makeBox({0.2, 0.2, 0.02}), Pose::identity()),
                       test::partAt("drawer", makeBox({0.1, 0.1, 0.02}), Pose::translation({0.0, 0.0, 0.0201})),
                       test::partAt("pin", makeBox({0.01, 0.01, 0.02}), Pose::translation({0.0, 0.0, 0.0402}))},
                      false);
  AssemblyPlan plan;
  SequenceDemands said;

  PlanOfWords() {
    plan.bodies = {"cabinet", "drawer", "pin"};
    plan.staying = {"cabinet"};
    plan.steps = {upwards({"pin"}), upwards({"drawer"})};
    plan.steps[1].after = {1};
  }

  static AssemblyStep upwards(const std::vector<BodyId>& bodies) {
    AssemblyStep step{{StepMotion()}};
    step.only().body = bodies.front();
    step.only().with.assign(bodies.begin() + 1, bodies.end());
    step.only().path = computedPoints({Pose::identity(), Pose::translation({0.0, 0.0, 0.3})});
    return step;
  }
  check::PlanVerdict verdict() const { return judgePlan(plan, product, std::nullopt, {}, &said); }
  std::vector<std::string> conditions() const {
    std::vector<std::string> texts;
    for (const check::Condition& each : verdict().allConditions()) texts.push_back(toString(each.text));
    return texts;
  }
  void confirm(JointKind kind, const BodyId& body, const std::vector<BodyId>& others) {
    JointEdit edit;
    edit.key = {kind, body, others};
    edit.word = JointEdit::Word::Confirmed;
    said.joints.push_back(edit);
  }
};

TEST_F(PlanOfWords, SayWhatAMotionThatFailsDoes) {
  const auto why = [this](const check::PlanVerdict& judged) {
    return toString(check::whyInvalid(judged.steps.front(), judgedProduct(product)));
  };
  EXPECT_THAT(why(judgePlan(plan, product, 0.001, {}, &said)),
              HasSubstr("comes within 0.1 mm of 'drawer' on edge 0; the required clearance is 1 mm"));
  plan.steps[0].only().path.insert(plan.steps[0].only().path.begin() + 1,
                                   PathPoint{Pose::translation({0.0, 0.0, -0.01})});
  EXPECT_THAT(why(verdict()), HasSubstr("penetrates 'drawer' on edge 0"));
}

TEST_F(PlanOfWords, SaysHowPartsLeave) {
  const check::PlanVerdict judged = verdict();
  EXPECT_EQ(judged.outcome(), PlanOutcome::Valid) << check::reportText(judged, judgedProduct(product));
  EXPECT_EQ(judged.alone, 2U);

  plan.steps = {upwards({"drawer", "pin"})};
  const check::PlanVerdict group = verdict();
  EXPECT_TRUE(group.valid());
  EXPECT_EQ(group.outcome(), PlanOutcome::Incomplete);
  EXPECT_EQ(group.inGroups, 2U);
  EXPECT_THAT(check::reportText(group, judgedProduct(product)), HasSubstr("2 in groups that are not disassembled"));

  plan.steps[0].only().unit = true;
  EXPECT_EQ(verdict().outcome(), PlanOutcome::Conditional);
  EXPECT_THAT(conditions(), ElementsAre("'drawer', 'pin' are one unit"));
  confirm(JointKind::Unit, "drawer", {"pin"});
  EXPECT_EQ(verdict().outcome(), PlanOutcome::Valid);
  plan.steps[0].only().unit = false;
  EXPECT_EQ(verdict().outcome(), PlanOutcome::Valid) << "a person's word is enough";

  plan.lines = {{1, {"drawer", "pin"}, {"drawer"}, {upwards({"pin"})}, {}, {}}};
  said.joints.clear();
  EXPECT_EQ(verdict().outcome(), PlanOutcome::Valid);
  plan.lines[0].steps.clear();
  EXPECT_EQ(verdict().outcome(), PlanOutcome::Incomplete) << "the pin does not leave the group";
  plan.lines[0].staying = {"drawer", "pin"};
  EXPECT_EQ(verdict().outcome(), PlanOutcome::Conditional) << "the line calls all of its bodies a unit";
}

TEST_F(PlanOfWords, APartWithoutAStepIsNotComplete) {
  plan.steps.pop_back();
  plan.end = PlanEnd::Stuck;
  EXPECT_EQ(verdict().outcome(), PlanOutcome::Incomplete);
  plan.staying.emplace_back("drawer");
  plan.end = PlanEnd::Complete;
  EXPECT_EQ(verdict().outcome(), PlanOutcome::Conditional);
  EXPECT_THAT(conditions(), ElementsAre("'cabinet', 'drawer' are fixed as base"));
  said.stay = {"cabinet", "drawer"};
  EXPECT_EQ(verdict().outcome(), PlanOutcome::Valid);
}

TEST_F(PlanOfWords, AFlexibleBodyIsAPersonsWord) {
  AssemblyStep& belt = plan.steps[0];
  belt.only().certified = false;
  belt.only().joints.emplace_back().kind = JointKind::Flexible;
  belt.only().joints[0].body = "pin";
  EXPECT_EQ(verdict().outcome(), PlanOutcome::Conditional);
  EXPECT_THAT(conditions(), ElementsAre("'pin' is flexible, so that its motion needs no certificate"));
  plan.demands.joints = {JointEdit{{JointKind::Flexible, "pin", {}}, JointEdit::Word::Confirmed}};
  EXPECT_EQ(verdict().outcome(), PlanOutcome::Conditional) << "the plan confirms itself";
  confirm(JointKind::Flexible, "pin", {});
  EXPECT_EQ(verdict().outcome(), PlanOutcome::Valid);
  EXPECT_EQ(verdict().stepsWithoutProof(), 1U);
}

/// The reason is in the plan, or in the scenario: the demand is broken in both cases.
TEST_F(PlanOfWords, ADemandIsGivenUpOnlyUnderACondition) {
  for (SequenceDemands* demands : {&plan.demands, &said}) {
    plan.demands = {};
    said = {};
    plan.steps[0].violates.clear();
    demands->before = {{"drawer", "pin"}};
    EXPECT_EQ(verdict().outcome(), PlanOutcome::Invalid);
    plan.steps[0].violates = {{StepViolation::Rule::Before, {"drawer"}}};
    EXPECT_EQ(verdict().outcome(), PlanOutcome::Conditional);
    EXPECT_THAT(conditions(),
                ElementsAre("'pin' may be removed before 'drawer', although a constraint states the reverse"));
  }
  plan.demands = {};
  said = {};
  plan.steps[0].violates = {{StepViolation::Rule::Place, {}}};
  said.places = {{{"pin"}, 2}};
  EXPECT_THAT(conditions(), ElementsAre("'pin' may be removed as number 1, although a constraint states number 2"));
  plan.steps[0].violates = {{StepViolation::Rule::Standing, {"drawer"}}};
  said.places.clear();
  EXPECT_THAT(conditions(), ElementsAre());
  EXPECT_EQ(verdict().steps[0].notes.size(), 1U) << "nobody demands it";
}

/// Changes each number alone; the refusal names its key.
TEST_F(PlanOfWords, NumbersThatAreWrongAreRefused) {
  product.fits.on = true;
  plan = test::planOf(product, "cabinet");
  ASSERT_EQ(plan.steps.size(), 2U);
  ASSERT_EQ(verdict().outcome(), PlanOutcome::Valid) << check::reportText(verdict(), judgedProduct(product));
  const AssemblyPlan sound = plan;
  const auto refusalOf = [&](const std::function<void(AssemblyStep&)>& change) {
    plan = sound;
    change(plan.steps[0]);
    std::string all;
    const check::PlanVerdict judged = verdict();
    for (const Message& each : judged.steps[0].refusals) all += toString(each) + "\n";
    return all;
  };
  const auto joint = [](AssemblyStep& step) -> StepJoint& {
    step.only().joints = {{JointKind::Screw, "pin", {"drawer"}}};
    return step.only().joints[0];
  };
  EXPECT_EQ(refusalOf([](AssemblyStep&) {}), "");
  EXPECT_THAT(refusalOf([](AssemblyStep& step) { step.only().proof.required *= 2.0; }), HasSubstr("\"required_m\""));
  EXPECT_THAT(refusalOf([](AssemblyStep& step) { step.only().proof.provedClearance = 9.9; }),
              HasSubstr("\"proved_clearance_m\""));
  EXPECT_THAT(refusalOf([](AssemblyStep& step) { step.only().proof.minClearance *= 0.5; }),
              HasSubstr("\"min_clearance_m\""));
  EXPECT_THAT(refusalOf([](AssemblyStep& step) { step.only().proof.afterSteps = 7; }), HasSubstr("\"after_steps\": 7"));
  EXPECT_THAT(refusalOf([](AssemblyStep& step) { step.only().proof.nearest = "nobody"; }), HasSubstr("'nobody'"));
  EXPECT_THAT(refusalOf([](AssemblyStep& step) { step.wave = 1000; }), HasSubstr("\"wave\": 1000"));
  EXPECT_THAT(refusalOf([](AssemblyStep& step) { step.task = 1000; }), HasSubstr("\"task\": 1000"));
  EXPECT_THAT(refusalOf([&](AssemblyStep& step) { joint(step).bend = 1e-3; }), HasSubstr("\"bend_m\""));
  EXPECT_THAT(refusalOf([&](AssemblyStep& step) { joint(step).driveSize = 9.9; }), HasSubstr("\"drive_size_m\": 9.9"));
  EXPECT_THAT(refusalOf([&](AssemblyStep& step) {
                joint(step).drive = DriveKind::HexOutside;
                step.only().joints[0].driveSize = 0.015;
              }),
              HasSubstr("\"drive_size_m\": 0.015"));
  EXPECT_EQ(refusalOf([&](AssemblyStep& step) {
              joint(step).drive = DriveKind::HexOutside;
              step.only().joints[0].driveSize = 0.01;
            }),
            "")
      << "two faces are so far apart";
  EXPECT_THAT(refusalOf([&](AssemblyStep& step) {
                joint(step).pitch = 1e-3;
                step.only().joints[0].diameter = 0.5;
                step.only().joints[0].turns = 1000.0;
              }),
              testing::AllOf(HasSubstr("\"turns\": 1000"), HasSubstr("\"diameter_m\": 0.5")));
}

/// A nut on a bolt, marked as a thread.
AssembledProduct nutOnABolt() {
  AssembledProduct product =
      test::productOf({test::partAt("bolt", test::plainBolt(), Pose::identity()),
                       test::partAt("nut", test::hexNut(), Pose::translation({0.0, 0.0, 0.0075}))},
                      true);
  product.fits.pairs = {{"nut", "bolt", ContactKind::Thread, {}, false}};
  return product;
}

/// A plan that turns the nut off by this pitch, metres a turn.
AssemblyPlan turnedBy(const AssembledProduct& product, double pitch) {
  AssemblyPlan plan = test::planOf(product, "bolt");
  AssemblyStep& step = plan.steps[0];
  const Pose first = step.only().path.front().q;
  const Vector3 way = step.only().path.back().q.position - first.position;
  const double edges = std::ceil(4.0 * way.norm() / std::abs(pitch));
  step.only().path = {step.only().path.front()};
  for (int i = 1; i <= static_cast<int>(edges); ++i) {
    const double share = i / edges;
    const double turn = 2.0 * std::numbers::pi * share * way.norm() / pitch;
    const Quaternion orientation(Eigen::AngleAxisd(turn, way.normalized()));
    step.only().path.push_back({{first.position + share * way, orientation * first.orientation}, Author::Computer});
  }
  for (Allowance& each : step.only().allowances) {
    each.pitch = pitch;
    each.turns = way.norm() / std::abs(pitch);
  }
  return plan;
}

TEST(PlanWords, AnUnusualPitchOrHandIsACondition) {
  AssembledProduct product = nutOnABolt();
  const auto conditionsOf = [&](double pitch) {
    const check::PlanVerdict verdict = judgePlan(turnedBy(product, pitch), product, std::nullopt);
    std::string texts;
    for (const check::Condition& each : verdict.allConditions()) texts += toString(each.text) + ";";
    return verdict.valid() ? texts : "not valid: " + check::reportText(verdict, judgedProduct(product));
  };
  EXPECT_EQ(conditionsOf(test::kCoarsePitch), "");
  EXPECT_THAT(conditionsOf(0.0019), HasSubstr("which no standard thread of"));
  EXPECT_EQ(conditionsOf(-test::kCoarsePitch), "the thread of 'nut' in 'bolt' is left-handed;");
  product.fits.pairs[0].pitch = -test::kCoarsePitch;
  EXPECT_EQ(conditionsOf(-test::kCoarsePitch), "") << "a person says so";
  product.fits.pairs[0].pitch.reset();
  for (RigidBody& body : product.bodies) body.name += " M10 LH";
  EXPECT_EQ(conditionsOf(-test::kCoarsePitch), "") << "the names say so";
  EXPECT_THAT(conditionsOf(test::kCoarsePitch), HasSubstr("is right-handed, although a name says left-handed"));
}

/// Two crossing bars without notches: the plan brings the acceptance of their clash and the body that is cut.
TEST(PlanWords, AnAcceptedClashAndTheBodyThatIsCutAreConditions) {
  AssembledProduct product =
      test::productOf({test::partAt("along", makeBox({0.1, 0.01, 0.01}), Pose::identity()),
                       test::partAt("across", makeBox({0.01, 0.1, 0.01}), Pose::translation({0.0, 0.0, 0.004}))},
                      true);
  const auto says = [&](double accepted, const std::vector<std::string>& cut) {
    product.fits.acceptedClash = accepted;
    product.fits.cut = cut;
  };
  says(0.006, {"across"});
  test::QuietHost host;
  SequenceRequest request{{true, false}};
  const auto plan = planSequence(product, test::fitsOf(product), request, host);
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->steps.size(), 1U);
  const auto conditionsOf = [&] {
    const check::PlanVerdict verdict = judgePlan(*plan, product, std::nullopt);
    std::vector<std::string> texts;
    for (const check::Condition& each : verdict.allConditions()) texts.push_back(toString(each.text));
    if (!verdict.valid()) texts = {"not valid"};
    return texts;
  };
  const std::string cut = "'across' is the one that is cut (--cut \"across\")";
  EXPECT_THAT(conditionsOf(), testing::IsEmpty());
  says(0.006, {});
  EXPECT_THAT(conditionsOf(), ElementsAre(cut));
  says(0.0, {"across"});
  EXPECT_THAT(conditionsOf(), ElementsAre(HasSubstr("--accept-clashes 5mm")));
  says(0.0, {});
  EXPECT_THAT(conditionsOf(), ElementsAre(cut, HasSubstr("--accept-clashes 5mm")));
  says(0.006, {"along"});
  EXPECT_THAT(conditionsOf(), ElementsAre("not valid")) << "a person names the other one";
}

/// Values from the standards ISO 261, ASME B1.1 and ISO 1478, independent of the engine.
TEST(StandardPitch, IsThatOfAStandardThreadOfTheDiameter) {
  struct Row {
    double diameter;  ///< millimetres, as drawn
    double pitch;
    bool isStandard;
  };
  for (const Row& row :
       {Row{10.0, 1.5, true}, Row{10.0, 1.25, true}, Row{10.0, 4.9, false}, Row{10.0, 1.9, false}, Row{8.5, 1.5, true},
        Row{8.376, 1.5, true}, Row{6.0, 1.5, false}, Row{3.0, 0.5, true}, Row{3.0, 1.5, false}, Row{6.35, 1.27, true},
        Row{4.2, 1.4, true}, Row{13.0, 1.75, true}, Row{80.0, 6.0, true}, Row{80.0, 9.0, false}, Row{58.0, 2.0, true},
        Row{120.0, 2.0, true}, Row{58.0, 0.4, false}, Row{1.0, 0.25, true}, Row{10.0, -1.5, true}}) {
    EXPECT_EQ(check::isStandardPitch(1e-3 * row.diameter, 1e-3 * row.pitch), row.isStandard)
        << row.diameter << " x " << row.pitch;
  }
  for (const char* name : {"M10x1.5 LH left hand screw", "nut M8-LH", "Bolt left-hand"}) {
    EXPECT_TRUE(check::saysLeftHanded(name)) << name;
  }
  for (const char* name : {"M10x1.5", "bracket_left", "bracket LH", "left screw", "screw for the left bracket"}) {
    EXPECT_FALSE(check::saysLeftHanded(name)) << name;
  }
}

}  // namespace
}  // namespace glissade
