// Plans that keep to joints: hand-made joints, so that the tests do not depend on how joints are found.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "engine/files/judged_product.h"
#include "engine/sequence/held_by_base.h"
#include "engine/sequence/joined_units.h"
#include "engine/sequence/joint_removal.h"
#include "engine/sequence/joint_rules.h"
#include "engine/sequence/sequence_run.h"
#include "engine/sequence/step_joints.h"
#include "tests/engine/fits/ring.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

constexpr double kPitch = 0.0008;
constexpr double kEngaged = 0.004;

/// A part whose triangles are one face, as in a CAD file.
RigidBody partOf(const std::string& name, TriangleMesh mesh, const Vector3& at) {
  mesh.faces.emplace_back();
  mesh.faceOf.assign(mesh.triangles.size(), 0);
  RigidBody body = boxBody(name, {1.0, 1.0, 1.0}, Pose::translation(at));
  body.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
  return body;
}

/// A shaft of 5 mm along z, 14 mm long, with a head of 9 mm above z = 0.
TriangleMesh headedScrew() {
  TriangleMesh mesh = test::makeRing(0.0, 0.0025, 0.014, 36);
  for (Vector3& vertex : mesh.vertices) vertex.z() -= 0.006;
  append(mesh, transformed(test::makeRing(0.0, 0.0045, 0.003, 36), Pose::translation({0.0, 0.0, 0.0016})));
  return mesh;
}

/// A hole of 5.2 mm in a base, a cover on it with a hole of 5.8 mm, and the screw in both.
AssembledProduct screwedCover() {
  return test::productOf({partOf("base", test::makeRing(0.0026, 0.03, 0.02, 48), {0.0, 0.0, -0.0151}),
                          partOf("cover", test::makeRing(0.0029, 0.02, 0.0049, 48), {0.0, 0.0, -0.0025}),
                          partOf("screw", headedScrew(), Vector3::Zero())});
}

Joint screwIn(std::size_t body, std::vector<std::size_t> others, std::vector<std::size_t> clamped) {
  Joint joint;
  joint.body = body;
  joint.others = std::move(others);
  joint.clamped = std::move(clamped);
  joint.thread = JointThread{0.005, kPitch, false, kEngaged, kEngaged};
  return joint;
}

Joint jointOf(JointKind kind, std::size_t body, std::vector<std::size_t> others) {
  Joint joint;
  joint.kind = kind;
  joint.body = body;
  joint.others = std::move(others);
  return joint;
}

AssemblyPlan planOf(const AssembledProduct& product, const Joints& joints, const BodyId& staying,
                    JointUse use = JointUse::Recognised) {
  test::QuietHost host;
  SequenceRequest request{BodySet(product.bodies.size(), false)};
  request.staying[product.indexOf(staying)] = true;
  request.demands.jointUse = use;
  request.joints = &joints;
  auto plan = planSequence(product, test::fitsOf(product), request, host);
  EXPECT_TRUE(plan.ok());
  return std::move(*plan);
}

/// A rod without a head lets its nut off at either end.
TEST(JointPlans, ANutLeavesByTheOtherEndWhereOneIsForbidden) {
  const AssembledProduct product =
      test::productOf({partOf("rod", test::makeRing(0.0, 0.0025, 0.03, 36), Vector3::Zero()),
                       partOf("nut", test::makeRing(0.0026, 0.005, 0.004, 36), {0.0, 0.0, 0.009})});
  Joint nut = screwIn(1, {0}, {});
  nut.kind = JointKind::Nut;
  nut.thread->travel = 0.008;
  for (const double forbidden : {0.0, 1.0, -1.0}) {
    test::QuietHost host;
    SequenceRequest request{{true, false}};
    const Joints joints{nut};
    request.joints = &joints;
    if (forbidden != 0.0) request.demands.forbidden = {{"nut", forbidden * Vector3::UnitZ()}};
    const auto plan = planSequence(product, test::fitsOf(product), request, host);
    ASSERT_TRUE(plan);
    ASSERT_EQ(plan->steps.size(), 1U) << forbidden;
    const std::vector<PathPoint>& path = plan->steps[0].only().path;
    EXPECT_EQ(path.back().q.position.z() > path.front().q.position.z(), forbidden <= 0.0);
    EXPECT_TRUE(judgePlan(*plan, product, std::nullopt, {}).valid()) << forbidden;
  }
}

/// A person puts the cover before its screw.
TEST(JointPlans, AScrewThatClampsAPartIsNamedWhereAPersonMovesTheStep) {
  const AssembledProduct product = screwedCover();
  const Joints joints{screwIn(2, {0}, {1})};
  const AssemblyPlan plan = planOf(product, joints, "base");
  ASSERT_EQ(test::orderOf(plan), (std::vector<BodyId>{"screw", "cover"}));
  test::QuietHost host;
  SequenceRequest request{{true, false, false}};
  request.resumed = &plan;
  request.joints = &joints;
  const auto answer = planWithOrder(product, test::fitsOf(product), request, {1, 0}, host);
  ASSERT_TRUE(answer);
  const auto* conflict = std::get_if<OrderConflict>(&*answer);
  ASSERT_NE(conflict, nullptr);
  EXPECT_EQ(toString(conflict->reason), "'screw' clamps 'cover'");
}

AssembledProduct boxesInARow(std::size_t count) {
  std::vector<RigidBody> bodies;
  for (std::size_t i = 0; i < count; ++i) {
    bodies.push_back(boxBody("b" + std::to_string(i), {0.5, 0.5, 0.5}, Pose::translation({double(i), 0.0, 0.0})));
  }
  return test::productOf(std::move(bodies));
}

JointRules rulesOf(const Joints& joints, std::size_t bodies) {
  return {joints, boxesInARow(bodies), std::vector<FastenerKind>(bodies, FastenerKind::None)};
}

TEST(JointRules, AScrewHoldsWhatItClampsAndWhatItIsScrewedInto) {
  const JointRules rules = rulesOf({screwIn(2, {0}, {1})}, 3);
  const BodySet all(3, true);
  EXPECT_EQ(rules.holding({1}, all, false), std::vector<std::size_t>{0});
  EXPECT_EQ(rules.holding({0}, all, false), std::vector<std::size_t>{0});
  EXPECT_TRUE(rules.holding({2}, all, false).empty()) << "the screw turns out";
  EXPECT_FALSE(rules.holding({1, 2}, all, false).empty()) << "a screw does not turn with what it clamps";
  EXPECT_TRUE(rules.holding({0, 1, 2}, all, false).empty()) << "the whole joint moves as one";
  EXPECT_EQ(rules.opened({2}, all), std::vector<std::size_t>{0});
  EXPECT_TRUE(rules.opened({1}, all).empty());
  EXPECT_EQ(rules.holders({0}, {1}, all), BodyGroup{2});
}

TEST(JointRules, ANutOpensTheJointAndTheScrewStillLeavesBeforeWhatItClampsWhereItCan) {
  Joints joints{screwIn(2, {3}, {0, 1})};
  const JointRules rules(joints, boxesInARow(4),
                         {FastenerKind::None, FastenerKind::None, FastenerKind::Screw, FastenerKind::Nut});
  const BodySet all(4, true);
  EXPECT_TRUE(rules.holding({3}, all, true).empty()) << "a nut is turned off";
  EXPECT_EQ(rules.opened({3}, all), std::vector<std::size_t>{0});
  const BodySet noNut = without(all, {3});
  EXPECT_TRUE(rules.holding({1}, noNut, false).empty());
  EXPECT_EQ(rules.holding({1}, noNut, true), std::vector<std::size_t>{0});
}

TEST(JointRules, WhatIsOneBodyIsOneGroup) {
  const JointRules rules = rulesOf({jointOf(JointKind::Insert, 1, {0}), jointOf(JointKind::Unit, 3, {4}),
                                    jointOf(JointKind::Insert, 2, {1}), jointOf(JointKind::Pin, 5, {4})},
                                   6);
  EXPECT_EQ(rules.bonded(), (std::vector<BodyGroup>{{0, 1, 2}, {3, 4}}));
  OrderRules order;
  order.together = {{2, 5}};
  order.placed = {{{0}, 1}};
  joinUnits(rules.bonded(), boxesInARow(6), order);
  std::sort(order.together.begin(), order.together.end());
  EXPECT_EQ(order.together, (std::vector<BodyGroup>{{0, 1, 2, 5}, {3, 4}}));
  EXPECT_EQ(order.placed.front().group, (BodyGroup{0, 1, 2, 5}));
  EXPECT_EQ(withJoined({false, true, false, false, false, false}, rules.bonded()),
            (BodySet{true, true, true, false, false, false}));
}

TEST(JointRules, AlikeScrewsThatClampTheSameAreOneTask) {
  Joints joints{screwIn(2, {0}, {1}), screwIn(3, {0}, {1}), screwIn(4, {0}, {1}), screwIn(5, {0}, {6})};
  for (std::size_t i = 0; i < 4; ++i) joints[i].designation = i == 2 ? "M4x8" : "M3x8";
  const JointRules rules = rulesOf(joints, 7);
  EXPECT_EQ(rules.taskOf(2), 1U);
  EXPECT_EQ(rules.taskOf(3), 1U);
  EXPECT_EQ(rules.taskOf(4), 0U) << "another size";
  EXPECT_EQ(rules.taskOf(5), 0U) << "it clamps something else";
  EXPECT_EQ(toString(rules.inWords(rules.holding({1}, BodySet(7, true), false))), "2 screws M3x8 and 1 screw M4x8");
}

TEST(JointRules, ABoltItsNutAndItsWashersAreOneStackAndAlikeStacksAreOneTask) {
  Joints joints{screwIn(2, {3}, {1, 6}), screwIn(4, {5}, {1, 7}), screwIn(8, {0}, {1})};
  for (const std::size_t nut : {0, 1}) joints[nut].kind = JointKind::Nut;
  std::vector<FastenerKind> kinds(9, FastenerKind::None);
  kinds[6] = kinds[7] = FastenerKind::Washer;
  const JointRules rules(joints, boxesInARow(9), kinds);
  EXPECT_EQ(rules.stacks(), (std::vector<BodyGroup>{{2, 3, 6}, {4, 5, 7}}));
  EXPECT_EQ(rules.stackOf(3), 1U);
  EXPECT_EQ(rules.stackOf(7), 2U);
  EXPECT_EQ(rules.stackOf(1), 0U) << "a clamped part is no fastener";
  EXPECT_EQ(rules.stackOf(8), 0U) << "a screw alone";
  for (const std::size_t body : {2, 3, 4, 5, 6, 7}) EXPECT_EQ(rules.taskOf(body), 1U) << body;
}

TEST(JointRules, SuggestedJointsCountWhereTheyAreAskedFor) {
  Joints joints{screwIn(2, {0}, {1}), jointOf(JointKind::Flexible, 1, {0})};
  joints[1].state = JointState::Suggested;
  EXPECT_EQ(countingJoints(joints, JointUse::Off).size(), 0U);
  EXPECT_EQ(countingJoints(joints, JointUse::Recognised).size(), 1U);
  EXPECT_EQ(countingJoints(joints, JointUse::Suggested).size(), 2U);
}

TEST(TurnedAlong, NoEdgeTurnsByHalfACircleAndAFrameOffTheAxisHasMoreOfThem) {
  const ScrewAxis screw{{0.0, 0.0, 0.0}, Vector3::UnitZ(), kPitch};
  const Pose start = Pose::translation({0.0, 0.0, 0.01});
  const std::vector<Pose> onAxis = turnedAlong(screw, start, 5.0 * kPitch, 1e-8);
  EXPECT_EQ(onAxis.size(), 21U);
  EXPECT_NEAR(onAxis.back().position.z(), 0.01 + 5.0 * kPitch, 1e-15);
  for (std::size_t i = 1; i < onAxis.size(); ++i) {
    EXPECT_LT(angleBetween(onAxis[i - 1].orientation, onAxis[i].orientation), 0.51 * std::numbers::pi);
  }
  const double arm = 1e-5;
  const std::vector<Pose> beside = turnedAlong(screw, Pose::translation({arm, 0.0, 0.01}), 5.0 * kPitch, 1e-7);
  EXPECT_GT(beside.size(), onAxis.size());
  const Vector3 chord = 0.5 * (beside[0].position + beside[1].position);
  EXPECT_LT(arm - chord.head<2>().norm(), 1e-7);
}

TEST(JointPlan, AScrewTurnsOutBeforeWhatItClamps) {
  const AssembledProduct product = screwedCover();
  const AssemblyPlan plan = planOf(product, {screwIn(2, {0}, {1})}, "base");
  ASSERT_EQ(test::orderOf(plan), (std::vector<BodyId>{"screw", "cover"}));
  const AssemblyStep& step = plan.steps.front();
  EXPECT_EQ(step.only().method, kTurned);
  ASSERT_EQ(step.only().joints.size(), 1U);
  EXPECT_NEAR(step.only().joints.front().turns, kEngaged / kPitch, 1e-9);
  EXPECT_EQ(step.only().joints.front().clamped, std::vector<BodyId>{"cover"});
  EXPECT_NEAR(turnsOf(step.only().path), kEngaged / kPitch, 1e-9);
  EXPECT_EQ(plan.steps.back().after, std::vector<std::size_t>{1});
  EXPECT_TRUE(judgePlan(plan, product, std::nullopt, {}).valid()) << "the independent check proves the turn";
}

TEST(JointPlan, EitherOfTwoBodiesThatAreScrewedTogetherTurnsOffTheOther) {
  const AssembledProduct product = screwedCover();
  Joint thread = jointOf(JointKind::Thread, 2, {0});
  thread.thread = JointThread{0.005, kPitch, false, kEngaged, kEngaged};
  for (const BodyId& staying : std::vector<BodyId>{"base", "screw"}) {
    const AssemblyPlan plan = planOf(product, {thread}, staying);
    ASSERT_EQ(plan.steps.size(), 2U) << staying;
    for (const AssemblyStep& step : plan.steps) {
      const bool opens = step.only().body != "cover";
      EXPECT_EQ(step.only().method == kTurned, opens) << step.only().body;
      EXPECT_EQ(step.only().joints.size(), opens ? 1U : 0U);
    }
    EXPECT_TRUE(judgePlan(plan, product, std::nullopt, {}).valid());
  }
}

/// A roof over the screw leaves room for it to be lifted out of its hole, and a wall closes the way to one side.
TEST(JointPlan, AScrewBelowARoofLeavesAlongTwoLinesAfterItsTurn) {
  AssembledProduct product = screwedCover();
  const auto add = [&](const RigidBody& body) {
    product.bodies.push_back(aboutTheirMiddles({body}).front());
    product.deflections.push_back(0.0);
  };
  add(boxBody("roof", {0.03, 0.03, 0.002}, Pose::translation({0.0, 0.0, 0.0185})));
  add(boxBody("wall", {0.002, 0.03, 0.02}, Pose::translation({0.016, 0.0, 0.01})));
  test::QuietHost host;
  SequenceRequest request{{true, false, false, true, true}};
  const Joints joints{screwIn(2, {0}, {1})};
  request.joints = &joints;
  const auto plan = planSequence(product, test::fitsOf(product), request, host);
  ASSERT_TRUE(plan.ok());
  ASSERT_FALSE(plan->steps.empty());
  EXPECT_EQ(plan->steps.front().only().body, "screw");
  EXPECT_EQ(plan->steps.front().only().method, kTurned);
  EXPECT_TRUE(judgePlan(*plan, product, std::nullopt, {}).valid());
}

TEST(JointPlan, AClusterThatNothingJoinsToTheBaseLeavesAsOneAndIsTakenApart) {
  AssembledProduct product = screwedCover();
  product.bodies.push_back(
      aboutTheirMiddles({boxBody("rail", {0.5, 0.02, 0.02}, Pose::translation({0.0, 0.0, -0.036}))}).front());
  product.deflections.push_back(0.0);
  const AssemblyPlan plan = planOf(product, {screwIn(2, {0}, {1})}, "rail");
  ASSERT_EQ(plan.steps.size(), 1U);
  EXPECT_EQ(plan.steps.front().bodies(), (std::vector<BodyId>{"base", "cover", "screw"}));
  ASSERT_EQ(plan.lines.size(), 1U);
  EXPECT_EQ(plan.lines.front().staying, std::vector<BodyId>{"base"});
  EXPECT_EQ(plan.lines.front().steps.size(), 2U);
  EXPECT_EQ(plan.lines.front().steps.front().only().body, "screw");
}

/// The bolt turns out of a nut that cannot turn: the tool belongs to the motion of the bolt.
TEST(JointPlan, TheToolBelongsToTheMotionThatOpensTheJoint) {
  const AssembledProduct product =
      test::productOf({partOf("base", test::makeRing(0.0029, 0.03, 0.0049, 48), {0.0, 0.0, -0.0025}),
                       partOf("bolt", headedScrew(), Vector3::Zero()),
                       partOf("nut", test::makeRing(0.0026, 0.005, 0.004, 36), {0.0, 0.0, -0.0091}),
                       boxBody("stop", {0.02, 0.02, 0.004}, Pose::translation({0.0, 0.0, -0.0184}))});
  Joint joint = screwIn(2, {1}, {0});
  joint.kind = JointKind::Nut;
  joint.direction = -Vector3::UnitZ();
  const Joints joints{joint};
  test::QuietHost host;
  SequenceRequest request{{true, false, false, true}};
  request.joints = &joints;
  request.demands.fasteners = {{"bolt", "screw"}, {"nut", "nut"}};
  request.demands.tools = {{"bolt", "hex_key"}, {"nut", "socket"}};
  request.demands.before = {{"bolt", "nut"}};
  const auto plan = planSequence(product, test::fitsOf(product), request, host);
  ASSERT_TRUE(plan.ok());
  ASSERT_EQ(test::orderOf(*plan), (std::vector<BodyId>{"bolt", "nut"}));
  ASSERT_EQ(plan->steps.size(), 1U) << "the stack is one step";
  const std::vector<StepMotion>& motions = plan->steps[0].motions;
  EXPECT_EQ(motions[0].tool.kind, ToolKind::HexKey);
  EXPECT_EQ(motions[1].tool.kind, ToolKind::None) << "the nut is loose";
  EXPECT_EQ(plan->steps[0].opening().body, "bolt");
}

/// Two rings with a bolt and a nut each, beside each other, and a block.
struct TwoStacks {
  AssembledProduct product;
  Joints joints;
};
TwoStacks twoStacks() {
  TwoStacks made;
  std::vector<RigidBody> bodies;
  for (const double x : {0.0, 0.1}) {
    const std::string number = x == 0.0 ? "1" : "2";
    const std::size_t first = bodies.size();
    bodies.push_back(partOf("ring" + number, test::makeRing(0.0029, 0.03, 0.0049, 48), {x, 0.0, -0.0025}));
    bodies.push_back(partOf("bolt" + number, headedScrew(), {x, 0.0, 0.0}));
    bodies.push_back(partOf("nut" + number, test::makeRing(0.0026, 0.005, 0.004, 36), {x, 0.0, -0.0091}));
    Joint nut = screwIn(first + 2, {first + 1}, {first});
    nut.kind = JointKind::Nut;
    nut.point = {x, 0.0, 0.0};
    nut.direction = -Vector3::UnitZ();
    made.joints.push_back(nut);
  }
  bodies.push_back(boxBody("block", Vector3::Constant(0.02), Pose::translation({0.2, 0.0, 0.0})));
  made.product = test::productOf(std::move(bodies));
  return made;
}

/// Place 2 is between the stacks, although four motions come before the third step.
TEST(JointPlan, AStackCountsAsOneStepForTheDemandedPlaces) {
  const TwoStacks made = twoStacks();
  test::QuietHost host;
  for (const char* strategy : {"greedy", "best-first"}) {
    for (const std::size_t place : {1U, 2U, 3U}) {
      SequenceRequest request{{true, false, false, true, false, false, false}, strategy};
      request.joints = &made.joints;
      request.demands.fasteners = {{"bolt1", "screw"}, {"bolt2", "screw"}, {"nut1", "nut"}, {"nut2", "nut"}};
      request.demands.tools = {{"bolt1", "hex_key"}, {"bolt2", "hex_key"}, {"nut1", "socket"}, {"nut2", "socket"}};
      request.demands.places = {{{"block"}, place}};
      const auto plan = planSequence(made.product, test::fitsOf(made.product), request, host);
      ASSERT_TRUE(plan.ok());
      ASSERT_EQ(plan->steps.size(), 3U) << strategy << place;
      EXPECT_EQ(plan->steps[place - 1].motions.front().body, "block") << strategy << place;
      EXPECT_TRUE(plan->steps[place - 1].violates.empty());
      EXPECT_TRUE(judgePlan(*plan, made.product, std::nullopt).valid()) << strategy << place;
      const AssemblyStep& stack = plan->steps[place == 1 ? 1 : 0];
      EXPECT_EQ(stack.opening().tool.held, stack.motions[1].body) << "the other side is held";
      EXPECT_NE(stack.opening().tool.heldWith, ToolKind::None);
    }
  }
}

/// A stack whose place is demanded for its first motion comes there as a whole.
TEST(JointPlan, AMovedStackComesAtItsPlaceAsAWhole) {
  const TwoStacks made = twoStacks();
  test::QuietHost host;
  SequenceRequest request{{true, false, false, true, false, false, false}};
  request.joints = &made.joints;
  request.demands.fasteners = {{"bolt1", "screw"}, {"bolt2", "screw"}, {"nut1", "nut"}, {"nut2", "nut"}};
  for (const char* nut : {"nut1", "nut2"}) {
    request.demands.places = {{{nut}, 3}};
    const auto plan = planSequence(made.product, test::fitsOf(made.product), request, host);
    ASSERT_TRUE(plan.ok());
    ASSERT_EQ(plan->steps.size(), 3U);
    EXPECT_EQ(plan->steps[2].motions.size(), 2U);
    const std::vector<BodyId> last = plan->steps[2].bodies();
    EXPECT_NE(std::find(last.begin(), last.end(), BodyId(nut)), last.end());
    EXPECT_TRUE(judgePlan(*plan, made.product, std::nullopt).valid());
  }
}

TEST(JointPlan, WithoutJointsTheScrewIsPulled) {
  const AssembledProduct product = screwedCover();
  const AssemblyPlan plan = planOf(product, {screwIn(2, {0}, {1})}, "base", JointUse::Off);
  ASSERT_EQ(plan.steps.size(), 2U);
  for (const AssemblyStep& step : plan.steps) EXPECT_EQ(step.only().method, "straight");
  EXPECT_TRUE(plan.steps.front().only().joints.empty());
}

TEST(JointPlan, WhatIsInTheWayOfATurnIsNamedAndNothingIsPulled) {
  AssembledProduct product = screwedCover();
  RigidBody wall = boxBody("wall", {0.001, 0.01, 0.01}, Pose::translation({0.0043, 0.0, 0.0055}));
  product.bodies.push_back(aboutTheirMiddles({wall}).front());
  product.deflections.push_back(0.0);
  Joints joints{screwIn(2, {0}, {1})};
  test::QuietHost host;
  SequenceRequest request{{true, false, false, true}};
  request.joints = &joints;
  const auto plan = planSequence(product, test::fitsOf(product), request, host);
  ASSERT_TRUE(plan.ok());
  EXPECT_TRUE(plan->steps.empty());
  ASSERT_EQ(plan->stuck.size(), 2U);
  const auto stuck = [&](const BodyId& id) {
    return *std::find_if(plan->stuck.begin(), plan->stuck.end(),
                         [&](const StuckBody& each) { return each.body == id; });
  };
  EXPECT_EQ(stuck("screw").blockedBy, std::vector<BodyId>{"wall"});
  EXPECT_EQ(toString(stuck("cover").reason), "held by 1 screw of 5 mm: remove these first");
  EXPECT_EQ(stuck("cover").blockedBy, std::vector<BodyId>{"screw"});
}

TEST(JointPlan, AnInsertLeavesWithItsHostAndIsCounted) {
  AssembledProduct product = screwedCover();
  const AssemblyPlan plan = planOf(product, {jointOf(JointKind::Insert, 2, {1})}, "base");
  ASSERT_EQ(plan.steps.size(), 1U);
  EXPECT_EQ(plan.steps.front().bodies(), (std::vector<BodyId>{"cover", "screw"}));
  EXPECT_EQ(plan.removed(), 2U);
  const AssemblyPlan pressedIntoTheBase = planOf(product, {jointOf(JointKind::Insert, 2, {0})}, "base");
  EXPECT_EQ(pressedIntoTheBase.staying, (std::vector<BodyId>{"base", "screw"}));
  EXPECT_EQ(pressedIntoTheBase.parts(), 1U);
}

TEST(JointPlan, WhatStaysWithTheBaseIsNamedWithItsJoint) {
  const AssembledProduct product = boxesInARow(6);
  const Joints joints{jointOf(JointKind::Insert, 1, {0}), jointOf(JointKind::Permanent, 2, {1}),
                      jointOf(JointKind::Unit, 3, {4}), jointOf(JointKind::Pin, 5, {0})};
  const BodySet base{true, false, false, false, false, false};
  const auto held = heldByBase(product, joints, {true, true, true, false, false, false}, base);
  ASSERT_EQ(held.size(), 2U);
  EXPECT_EQ(held[0].body, product.bodies[1].id);
  EXPECT_EQ(held[0].kind, JointKind::Insert);
  EXPECT_EQ(held[0].with, product.bodies[0].id);
  EXPECT_EQ(held[1].body, product.bodies[2].id);
  EXPECT_EQ(held[1].with, product.bodies[1].id);
}

TEST(JointPlan, AFlexibleBodyLeavesWithoutAProofBeforeWhatItGoesAround) {
  const AssembledProduct product = test::chain();
  Joint belt = jointOf(JointKind::Flexible, 0, {1});
  const AssemblyPlan held = planOf(product, {}, "block");
  EXPECT_TRUE(held.end == PlanEnd::Stuck || held.steps.size() == 1U) << "the links hold each other";
  const AssemblyPlan plan = planOf(product, {belt}, "block");
  ASSERT_EQ(test::orderOf(plan), (std::vector<BodyId>{"one", "other"}));
  EXPECT_FALSE(plan.steps.front().only().certified);
  EXPECT_EQ(plan.steps.front().only().method, kFlexible);
  EXPECT_TRUE(plan.steps.back().only().certified) << "nothing else loses its proof";
  EXPECT_EQ(plan.steps.back().after, std::vector<std::size_t>{1});
  EXPECT_EQ(plan.removedWithoutProof(), 1U);
  EXPECT_EQ(plan.end, PlanEnd::Complete);
}

TEST(JointPlan, StepsOfOneTaskFollowEachOther) {
  std::vector<RigidBody> bodies{partOf("base", test::makeRing(0.001, 0.2, 0.02, 48), {0.0, 0.0, -0.02})};
  Joints joints;
  // Separate posts of growing size; the first, third and fifth are one task.
  for (std::size_t i = 0; i < 6; ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / 3.0;
    bodies.push_back(boxBody("post" + std::to_string(i), {0.01, 0.01, 0.02 + 0.001 * static_cast<double>(i)},
                             Pose::translation({0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.01})));
    joints.push_back(screwIn(i + 1, {0}, {7}));
    joints.back().point = bodies.back().X_WB.position;
    joints.back().designation = i % 2 == 0 ? "M3x8" : "M4x8";
  }
  bodies.push_back(boxBody("far", {0.01, 0.01, 0.01}, Pose::translation({0.15, 0.15, 0.01})));
  const AssemblyPlan plan = planOf(test::productOf(std::move(bodies)), joints, "base");
  ASSERT_EQ(plan.steps.size(), 7U);
  std::vector<std::size_t> tasks;
  for (const AssemblyStep& step : plan.steps) tasks.push_back(step.task);
  EXPECT_EQ(tasks, (std::vector<std::size_t>{1, 1, 1, 2, 2, 2, 0}));
}

}  // namespace
}  // namespace glissade
