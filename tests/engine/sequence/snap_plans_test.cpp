// A cap whose annular hook is behind the edge of a hole: it leaves only where a person permits the hook to bend.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/base/random_stream.h"
#include "engine/evidence/hook.h"
#include "engine/files/judged_product.h"
#include "engine/fits/joint_edits.h"
#include "engine/fits/joint_finder.h"
#include "engine/fits/snap_ways.h"
#include "engine/sequence/joint_rules.h"
#include "engine/sequence/sequence_run.h"
#include "tests/engine/fits/ring.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

constexpr double kHole = 0.005;  ///< radius
constexpr int kSides = 48;

/// A closed profile of radii and heights, revolved about z.
TriangleMesh turnedProfile(const std::vector<std::pair<double, double>>& profile) {
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(profile.size());
  for (int k = 0; k < kSides; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kSides;
    for (const auto& [r, z] : profile) mesh.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  for (std::uint32_t k = 0; k < kSides; ++k) {
    const std::uint32_t next = (k + 1) % kSides;
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t j = (i + 1) % n;
      mesh.triangles.push_back({k * n + i, next * n + i, next * n + j});
      mesh.triangles.push_back({k * n + i, next * n + j, k * n + j});
    }
  }
  return mesh;
}

RigidBody bodyOf(const std::string& id, TriangleMesh mesh) {
  RigidBody body = boxBody(id, {1.0, 1.0, 1.0}, Pose::identity());
  body.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
  return body;
}

/// A sleeve of 1.45 mm with a flange above a plate of 4 mm and a nose below it.
AssembledProduct cappedHole(double nose) {
  const double tip = kHole + nose;
  TriangleMesh cap = turnedProfile({{0.0035, 0.006},
                                    {0.008, 0.006},
                                    {0.008, 0.004},
                                    {0.00495, 0.004},
                                    {0.00495, -0.00005},
                                    {tip, -0.00005},
                                    {tip, -0.0004},
                                    {0.0046, -0.0016},
                                    {0.0035, -0.0016}});
  TriangleMesh plate = test::makeRing(kHole, 0.015, 0.004, kSides);
  const double low = boundingBox(plate).min().z();
  for (Vector3& vertex : plate.vertices) vertex.z() -= low;
  return test::productOf({bodyOf("plate", std::move(plate)), bodyOf("cap clip", std::move(cap))}, true);
}

AssemblyPlan planOf(AssembledProduct product, const Joints& joints, JointUse use) {
  test::QuietHost host;
  product.snaps = bendsOf(countingJoints(joints, use), product);
  SequenceRequest request{BodySet{true, false}};
  request.demands.jointUse = use;
  request.joints = &joints;
  auto plan = planSequence(product, test::fitsOf(product), request, host);
  EXPECT_TRUE(plan.ok());
  return std::move(*plan);
}

std::string inMillimetres(double metres) { return toString(Message(GLISSADE_TEXT("%1"), {Length{metres}})); }

bool isValid(const AssemblyPlan& plan, const AssembledProduct& product) {
  return judgePlan(plan, product, std::nullopt, {}).valid();
}

/// The distance of facets from the axis is reduced by the cosine of half their angle.
TEST(SnapWays, TheLeastBendIsTheNoseThatIsBehindTheEdge) {
  RandomStream stream(3, "noses");
  for (int i = 0; i < 5; ++i) {
    const double nose = stream.uniform(0.0001, 0.0006);
    const AssembledProduct product = cappedHole(nose);
    const auto ways = snapWays(product, 1, {0}, {});
    ASSERT_EQ(ways.size(), 1U) << nose;
    EXPECT_EQ(ways[0].direction, Vector3::UnitZ());
    EXPECT_GE(ways[0].bend, nose * std::cos(std::numbers::pi / kSides));
    EXPECT_LE(ways[0].bend, 1.05 * nose + 5e-5);
  }
}

TEST(SnapWays, AHookThatIsThickerThanItsArmDoesNotBendSoFar) {
  EXPECT_TRUE(snapWays(cappedHole(0.0025), 1, {0}, {}).empty());
}

TEST(Hooks, AreTheFacesThatTheEdgePassesAndNoOthers) {
  const AssembledProduct product = cappedHole(0.0005);
  const RigidBody& cap = product.bodies[1];
  const evidence::PlacedBody hook({cap.id, cap.name, cap.mesh, cap.X_WB}, cap.X_WB);
  const evidence::PlacedBody edge({"plate", "plate", product.bodies[0].mesh, product.bodies[0].X_WB},
                                  product.bodies[0].X_WB);
  const auto regions = evidence::hookRegions({hook, edge, Vector3::UnitZ(), 0.0005}, {});
  for (std::uint32_t t = 0; t < hook.normals.size(); ++t) {
    const Triangle& triangle = hook.tree.triangles()[t];
    const Vector3 middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
    const bool isOfNose = middle.z() < -1e-5 && middle.z() > -0.0012 && middle.head<2>().norm() > 0.0049;
    const bool catches = hook.normals[t].z() > 0.9;
    if (regions[hook.regions.of[t]]) {
      EXPECT_LT(middle.z(), 0.0);
      EXPECT_GT(middle.head<2>().norm(), 0.0046);
    }
    EXPECT_TRUE(regions[hook.regions.of[t]] || !isOfNose || catches) << middle.transpose();
  }
  const auto back = evidence::hookRegions({hook, edge, -Vector3::UnitZ(), 0.0005}, {});
  for (std::uint32_t t = 0; t < hook.normals.size(); ++t) {
    EXPECT_TRUE(!back[hook.regions.of[t]] || hook.tree.triangles()[t][0].z() > 0.003) << "only the flange";
  }
}

TEST(SnapPlans, ABendCountsOnlyWhereAPersonConfirmsIt) {
  const AssembledProduct product = cappedHole(0.0004);
  const Joints found = findJoints(product);
  ASSERT_EQ(found.size(), 1U);
  ASSERT_EQ(found[0].kind, JointKind::Snap);
  EXPECT_GT(found[0].bend, 0.0);
  EXPECT_TRUE(planOf(product, found, JointUse::Recognised).steps.empty());
  const AssemblyPlan plan = planOf(product, found, JointUse::Suggested);
  ASSERT_EQ(plan.steps.size(), 1U);
  ASSERT_EQ(plan.steps[0].only().joints.size(), 1U);
  EXPECT_EQ(plan.steps[0].only().joints[0].bend, found[0].bend);
  EXPECT_TRUE(isValid(plan, product));
}

TEST(SnapPlans, AStuckPartSaysWhichBendIsMissing) {
  const AssembledProduct product = cappedHole(0.0004);
  Joints found = findJoints(product);
  ASSERT_EQ(found.size(), 1U);
  const double needed = found[0].bend;
  found[0].bend = 0.5 * needed;
  const AssemblyPlan plan = planOf(product, found, JointUse::Suggested);
  ASSERT_EQ(plan.stuck.size(), 1U);
  EXPECT_EQ(toString(plan.stuck[0].reason), "the snap with 'plate' was tried in the direction +Z with a bend of " +
                                                inMillimetres(0.5 * needed) + ", and needs " + inMillimetres(needed) +
                                                ": change the joint to this bend");
}

TEST(SnapPlans, APartThatIsClippedInSaysWhichSnapWouldLetItGo) {
  const AssembledProduct product = cappedHole(0.0004);
  const AssemblyPlan plan = planOf(product, {}, JointUse::Suggested);
  ASSERT_EQ(plan.stuck.size(), 1U);
  EXPECT_THAT(toString(plan.stuck[0].reason),
              testing::HasSubstr("it would leave in the direction +Z if 'cap clip' bends by "));
  const AssemblyPlan tooLarge = planOf(cappedHole(0.0025), {}, JointUse::Suggested);
  ASSERT_EQ(tooLarge.stuck.size(), 1U);
  EXPECT_THAT(toString(tooLarge.stuck[0].reason), testing::HasSubstr("if 'plate' bends by 3 mm"))
      << "not the thick hook";
}

/// The plan keeps its motion and its allowance; the statement on which it relies is changed or removed.
TEST(SnapPlans, TheJudgeAcceptsNoOtherWord) {
  const AssembledProduct product = cappedHole(0.0004);
  const AssemblyPlan plan = planOf(product, findJoints(product), JointUse::Suggested);
  ASSERT_EQ(plan.demands.joints.size(), 1U);
  const JointEdit word = plan.demands.joints[0];
  const auto isValidWith = [&](const std::vector<JointEdit>& words) {
    AssemblyPlan changed = plan;
    changed.demands.joints = words;
    return isValid(changed, product);
  };
  EXPECT_TRUE(isValidWith({word}));
  EXPECT_FALSE(isValidWith({}));
  JointEdit changed = word;
  changed.made->bend *= 0.9;
  EXPECT_FALSE(isValidWith({changed}));
  changed = word;
  changed.made->direction = -Vector3::UnitZ();
  EXPECT_FALSE(isValidWith({changed}));
  changed = word;
  std::swap(changed.key.body, changed.key.others.front());
  EXPECT_FALSE(isValidWith({changed}));
  changed = word;
  changed.word = JointEdit::Word::Dissolved;
  EXPECT_FALSE(isValidWith({word, changed})) << "what is said last counts";
  changed = word;
  changed.made->bend = 0.05;
  EXPECT_FALSE(isValidWith({changed})) << "no hook bends so far";
}

/// There is room beside the sleeve: the motion aside and then up is free with the thinned hook.
TEST(SnapPlans, AHookBendsOnTheWayThatThePersonSaysOnly) {
  const AssembledProduct product = cappedHole(0.0004);
  const AssemblyPlan plan = planOf(product, findJoints(product), JointUse::Suggested);
  ASSERT_EQ(plan.steps.size(), 1U);
  AssemblyPlan aside = plan;
  std::vector<PathPoint>& path = aside.steps[0].only().path;
  ASSERT_EQ(path.size(), 2U);
  const Vector3 off(1e-6, 0.0, 0.0);
  PathPoint between = path.front();
  between.q.position += off;
  path.back().q.position += off;
  path.insert(path.begin() + 1, between);
  EXPECT_FALSE(isValid(aside, product));
  aside = plan;
  aside.steps[0].only().path.back().q.orientation = fromRollPitchYaw(0.0, 0.0, 0.3);
  EXPECT_FALSE(isValid(aside, product)) << "it turns";
}

/// The path leads out as stated, and then in again: no statement permits the hook to bend on the way in.
TEST(SnapPlans, AHookDoesNotBendOnTheWayBackIn) {
  const AssembledProduct product = cappedHole(0.0004);
  AssemblyPlan plan = planOf(product, findJoints(product), JointUse::Suggested);
  ASSERT_EQ(plan.steps.size(), 1U);
  std::vector<PathPoint>& path = plan.steps[0].only().path;
  ASSERT_EQ(path.size(), 2U);
  const std::vector<PathPoint> once = path;
  path.insert(path.end(), once.begin(), once.end());
  EXPECT_FALSE(isValid(plan, product));
  path = once;
  PathPoint high = once.back();
  high.q.position.z() += 1.0;
  PathPoint below = high;
  below.q.position.z() -= 3.0;
  path.insert(path.end(), {high, below});
  EXPECT_FALSE(isValid(plan, product)) << "through the hole, from one side to the other";
}

}  // namespace
}  // namespace glissade
