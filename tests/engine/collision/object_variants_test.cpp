#include <gtest/gtest.h>

#include "engine/collision/collision_query.h"
#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/thinned_mesh.h"
#include "engine/geometry/triangle_tree.h"
#include "tests/engine/fits/ring.h"
#include "tests/engine/support/independent_check.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

constexpr double kAllowance = 0.02;
constexpr double kVariantClearance = 1e-4;

RigidBody ringBody(const std::string& name, double inner, double outer, const Pose& X_WB) {
  RigidBody body = boxBody(name, {1.0, 1.0, 1.0}, X_WB);
  body.mesh = std::make_shared<const TriangleMesh>(test::makeRing(inner, outer, 0.3, 20));
  return body;
}

/// A bolt among a nut of its own radius, a second nut and blocks. Only against the first nut it is thinner.
struct BoltWorld {
  MeshPtr bolt = std::make_shared<const TriangleMesh>(test::makeRing(0.0, 0.2, 1.0, 20));
  std::vector<RigidBody> bodies{ringBody("nut", 0.2, 0.5, Pose::identity()),
                                boxBody("block", {0.5, 0.5, 0.5}, Pose::translation({0.9, 0.2, 0.0})),
                                ringBody("other nut", 0.2, 0.5, Pose::translation({0.0, 0.0, 1.2})),
                                boxBody("plate", {2.0, 2.0, 0.1}, Pose::translation({0.0, 0.0, -0.9}))};
  CollisionWorldPtr whole = CollisionWorld::build(bodies, bolt);
  MeshPtr thinner = std::make_shared<const TriangleMesh>(*ThinnableMesh::of(*bolt)->thinned(kAllowance));
  CollisionWorldPtr world = whole->withVariants({{thinner, {0}}});
};

Pose nearNut(RandomStream& random) {
  Pose pose = randomPose(random, 1.0);
  if (random.uniform() < 0.7) {
    pose =
        Pose::translation({0.02 * (random.uniform() - 0.5), 0.02 * (random.uniform() - 0.5), random.uniform() - 0.5});
  }
  return pose;
}

TEST(ObjectVariants, AVariantCountsAgainstItsOwnObstaclesOnly) {
  const BoltWorld bolt;
  const auto query = bolt.world->makeQuery();
  EXPECT_TRUE(bolt.whole->makeQuery()->collides(Pose::identity()));
  EXPECT_FALSE(query->collides(Pose::identity()));
  EXPECT_NEAR(query->nearestObstacle(Pose::identity()).distance, kAllowance, 1e-4);
  EXPECT_EQ(query->nearestObstacle(Pose::identity()).body, 0);
  EXPECT_EQ(query->collidingBody(Pose::translation({0.0, 0.0, 1.2})), 2);
  EXPECT_EQ(query->collidingBody(Pose::translation({0.0, 0.0, -0.4})), 3);
}

TEST(ObjectVariants, WithoutVariantsTheWorldIsTheSame) {
  const BoltWorld bolt;
  EXPECT_EQ(bolt.whole->withVariants({}), bolt.whole);
  const auto again = bolt.world->withVariants({});
  EXPECT_TRUE(again->variants().empty());
  EXPECT_TRUE(again->makeQuery()->collides(Pose::identity()));
}

TEST(ObjectVariants, BothBackendsAndTheJudgeAgree) {
  const BoltWorld bolt;
  const auto query = bolt.world->makeQuery();
  const auto fcl = bolt.world->withBackend(CollisionBackend::Fcl)->makeQuery();
  const IndependentCheck judge(bolt.bodies, *bolt.bolt, everywhere({kAllowance}, *bolt.bolt));
  RandomStream random(1, "variants");
  int certified = 0;
  for (int i = 0; i < 150; ++i) {
    const Pose from = nearNut(random);
    Pose to = from;
    to.position.z() += 0.4 * (random.uniform() - 0.5);
    EXPECT_EQ(query->collides(from), fcl->collides(from));
    EXPECT_EQ(query->collidingBody(from), fcl->collidingBody(from));
    const double distance = query->nearestObstacle(from).distance;
    EXPECT_NEAR(distance, fcl->nearestObstacle(from).distance, 1e-8);
    EXPECT_NEAR(query->distanceUpTo(from, 0.1), std::min(0.1, distance), 1e-12);
    EXPECT_EQ(query->clearAbove(from, 0.01), distance > 0.01);
    const MotionCheck check = query->checkMotion(from, to, kVariantClearance, SeekViolation::Any, {});
    const MotionCertificate judged = judge.check({from, to}, {{0.9 * kVariantClearance, false}});
    if (check.status == CertificateStatus::Certified) {
      EXPECT_EQ(judged.status, CertificateStatus::Certified);
    }
    certified += check.status == CertificateStatus::Certified ? 1 : 0;
    const MotionCheck first = query->checkMotion(from, to, kVariantClearance, SeekViolation::First, {});
    EXPECT_EQ(first.status, check.status);
    if (first.status == CertificateStatus::Violated) {
      EXPECT_LE(first.certified, first.at);
      EXPECT_FALSE(query->clearAbove(interpolate(from, to, first.at), kVariantClearance));
    }
  }
  EXPECT_GT(certified, 30);
  EXPECT_LT(certified, 140);
}

/// A gap of micrometres takes no more distance queries than a wide one, because straight motions are proved by their
/// swept volume.
TEST(ObjectVariants, TheJudgeProvesALongSlideInANarrowGap) {
  const BoltWorld bolt;
  constexpr double kNarrow = 1e-5;
  const IndependentCheck judge({bolt.bodies[0]}, *bolt.bolt, everywhere({kNarrow}, *bolt.bolt));
  const Pose out = Pose::translation({0.0, 0.0, 3.0});
  const MotionCertificate slide = judge.check({Pose::identity(), out}, {{0.2 * kNarrow, false}});
  EXPECT_EQ(slide.status, CertificateStatus::Certified);
  EXPECT_LT(slide.distanceQueries, 10U);
  EXPECT_NEAR(slide.minClearance, kNarrow, 1e-8);
  EXPECT_NEAR(slide.provedClearance, kNarrow, 1e-7);

  const Pose aslant = Pose::translation({0.0, 1e-4, 3.0});
  EXPECT_EQ(judge.check({Pose::identity(), aslant}, {{0.2 * kNarrow, false}}).status, CertificateStatus::Violated);
  // A small body on the motion is hit, however small it is.
  const std::vector<RigidBody> inTheWay{bolt.bodies[0],
                                        boxBody("crumb", {1e-3, 1e-3, 1e-3}, Pose::translation({0.05, 0.03, 1.7}))};
  const IndependentCheck careful(inTheWay, *bolt.bolt, everywhere({kNarrow}, *bolt.bolt));
  const MotionCertificate hit = careful.check({Pose::identity(), out}, {{0.2 * kNarrow, false}});
  EXPECT_EQ(hit.status, CertificateStatus::Violated);
  EXPECT_EQ(hit.nearest.body, 1);
}

/// Tests points of the bolt that are in every thinned variant, and points of its surface.
TEST(ObjectVariants, MotionsAreFreeWhereTheTrueBodyIsAndBlockedWhereItsCoreIs) {
  const BoltWorld bolt;
  const auto whole = bolt.whole->makeQuery();
  const auto query = bolt.world->makeQuery();
  RandomStream random(3, "motions");
  std::vector<Vector3> core;
  const TriangleTree surface(*bolt.bolt);
  while (core.size() < 60) {
    const Vector3 p{0.4 * (random.uniform() - 0.5), 0.4 * (random.uniform() - 0.5), random.uniform() - 0.5};
    const double depth = surface.nearest(p, 1.0).distance;
    if (depth > kLongestThinning * kAllowance && depth < 3.0 * kAllowance && containsPoint(*bolt.bolt, p)) {
      core.push_back(p);
    }
  }
  const auto isInObstacle = [&](const Pose& q, const Vector3& p) {
    return std::any_of(bolt.bodies.begin(), bolt.bodies.end(),
                       [&](const RigidBody& body) { return containsPoint(*body.mesh, inverse(body.X_WB) * (q * p)); });
  };
  int free = 0;
  int onlyThinned = 0;
  for (int i = 0; i < 10'000; ++i) {
    const Pose from = nearNut(random);
    Pose to = nearNut(random);
    to.position = from.position + 0.2 * (to.position - from.position);
    to.orientation = from.orientation.slerp(0.1 * random.uniform(), to.orientation);
    const bool isFree =
        query->checkMotion(from, to, kVariantClearance, SeekViolation::Any, {}).status == CertificateStatus::Certified;
    const bool trueIsFree =
        whole->checkMotion(from, to, kVariantClearance, SeekViolation::Any, {}).status == CertificateStatus::Certified;
    ASSERT_FALSE(trueIsFree && !isFree) << "the thinned body is larger than the true one";
    free += isFree ? 1 : 0;
    onlyThinned += isFree && !trueIsFree ? 1 : 0;
    if (!isFree) continue;
    const Pose q = interpolate(from, to, random.uniform());
    const Vector3& p = core[static_cast<std::size_t>(i) % core.size()];
    ASSERT_FALSE(isInObstacle(q, p)) << "free where the core is in an obstacle";
  }
  EXPECT_GT(free, 1000);
  EXPECT_GT(onlyThinned, 300);
}

}  // namespace
}  // namespace glissade
