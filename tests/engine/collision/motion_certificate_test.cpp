#include "engine/collision/motion_certificate.h"

#include <gtest/gtest.h>

#include "engine/geometry/se3_metric.h"
#include "tests/engine/collision/exact_reference.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

constexpr double kCertified = 1e-5;

class Certificate : public testing::Test {
 protected:
  void build(std::vector<RigidBody> obstacles, MeshPtr object) {
    bodies = obstacles;
    world = CollisionWorld::build(std::move(obstacles), std::move(object));
    query = world->makeQuery();
  }
  MotionCertificate certify(const Pose& from, const Pose& to, double required = kCertified) {
    return certifyMotion(*query, from, to, required);
  }

  std::vector<RigidBody> bodies;
  CollisionWorldPtr world;
  std::unique_ptr<CollisionQuery> query;
};

TEST_F(Certificate, WhatIsCertifiedIsFreeAtEveryConfigurationThatTheExactReferenceTries) {
  Pose tilted;
  tilted.orientation = fromRollPitchYaw(0.4, -0.7, 0.2);
  build({boxBody("a", {1, 2, 0.5}, tilted), boxBody("b", {0.4, 0.4, 3}, Pose::translation({1.5, 0, 0}))}, makeL());
  RandomStream stream(1, "motions");
  int certified = 0;
  int violated = 0;
  for (int i = 0; i < 300; ++i) {
    const Pose from = randomPose(stream, 2.5);
    const Pose to = randomPose(stream, 2.5);
    const MotionCertificate certificate = certify(from, to);
    ASSERT_NE(certificate.status, CertificateStatus::Undecided);
    if (certificate.status == CertificateStatus::Violated) {
      ++violated;
      const Pose at = interpolate(from, to, certificate.at);
      EXPECT_LT(query->nearestObstacle(at).distance, kCertified * 1.01);
      continue;
    }
    ++certified;
    EXPECT_GE(certificate.provedClearance, kCertified);
    for (int k = 0; k < 40; ++k) {
      const Pose q = interpolate(from, to, stream.uniform());
      ASSERT_FALSE(reference::collides(bodies, world->object(), q));
      ASSERT_GE(query->nearestObstacle(q).distance, certificate.provedClearance * (1.0 - 1e-9));
    }
  }
  EXPECT_GT(certified, 30);
  EXPECT_GT(violated, 30);
}

TEST_F(Certificate, AThinPlateDoesNotLetAnythingThrough) {
  build({boxBody("plate", {4, 4, 0.001}, Pose::identity())},
        std::make_shared<const TriangleMesh>(makeBox({.01, .01, .01})));
  const MotionCertificate certificate = certify(Pose::translation({0.3, 0.1, 3}), Pose::translation({-0.2, 0.4, -3.7}));
  EXPECT_EQ(certificate.status, CertificateStatus::Violated);
  EXPECT_NEAR(certificate.at, 3.0 / 6.7, 0.01);
  EXPECT_EQ(certificate.nearest.body, 0);
}

TEST_F(Certificate, SlidingAtTheContactGapIsCertified) {
  build({boxBody("plane", {20, 20, 0.2}, Pose::translation({0, 0, -0.1}))}, makeL());
  const double gap = 1e-3 * world->objectRadius();
  const MotionCertificate certificate =
      certify(Pose::translation({-1, 0, 0.2 + gap}), Pose::translation({1, 0.3, 0.2 + gap}));
  EXPECT_EQ(certificate.status, CertificateStatus::Certified);
  EXPECT_NEAR(certificate.minClearance, gap, 1e-9);
  EXPECT_LT(certificate.distanceQueries, 2000U);
  EXPECT_EQ(certify(Pose::translation({-1, 0, 0.2 + gap}), Pose::translation({1, 0.3, 0.2 + gap}), 2 * gap).status,
            CertificateStatus::Violated);
}

TEST_F(Certificate, FarFromEverythingAQueryOrTwoSettleIt) {
  build({boxBody("a", Vector3::Ones(), Pose::identity())}, makeL());
  const MotionCertificate certificate = certify(Pose::translation({50, 0, 0}), Pose::translation({50, 1, 0}));
  EXPECT_EQ(certificate.status, CertificateStatus::Certified);
  EXPECT_LE(certificate.distanceQueries, 2U);
}

TEST_F(Certificate, BeginningInsideASolidIsViolated) {
  build({boxBody("large", {4, 4, 4}, Pose::identity())}, std::make_shared<const TriangleMesh>(makeBox({.2, .2, .2})));
  EXPECT_EQ(certify(Pose::identity(), Pose::translation({0.1, 0, 0})).status, CertificateStatus::Violated);
}

TEST_F(Certificate, AStopLeavesItUndecided) {
  build({boxBody("plane", {20, 20, 0.2}, Pose::translation({0, 0, -0.1}))}, makeL());
  StopSource source;
  source.requestStop();
  EXPECT_EQ(
      certifyMotion(*query, Pose::translation({-1, 0, 1}), Pose::translation({1, 0, 1}), kCertified, source.token())
          .status,
      CertificateStatus::Undecided);
}

TEST_F(Certificate, APathReportsItsWorstEdge) {
  build({boxBody("plane", {20, 20, 0.2}, Pose::translation({0, 0, -0.1}))}, makeL());
  const std::vector<Pose> path{Pose::translation({0, 0, 2}), Pose::translation({1, 0, 0.5}),
                               Pose::translation({2, 0, 1})};
  const MotionCertificate certificate = certifyPath(*query, path, kCertified);
  EXPECT_EQ(certificate.status, CertificateStatus::Certified);
  EXPECT_NEAR(certificate.minClearance, 0.3, 1e-9);
  const std::vector<Pose> through{path[0], path[1], Pose::translation({2, 0, 0.1})};
  const MotionCertificate broken = certifyPath(*query, through, kCertified);
  EXPECT_EQ(broken.status, CertificateStatus::Violated);
  EXPECT_EQ(broken.edge, 1U);
}

TEST_F(Certificate, APathsClearanceIsBracketedFromFewDistances) {
  build({boxBody("plane", {20, 20, 0.2}, Pose::translation({0, 0, -0.1}))}, makeL());
  const double gap = 1e-3 * world->objectRadius();
  const std::vector<Pose> slide{Pose::translation({-3, 0, 0.2 + gap}), Pose::translation({3, 0.3, 0.2 + gap})};
  const MotionCertificate sliding = certifyPath(*query, slide, kCertified);
  EXPECT_EQ(sliding.status, CertificateStatus::Certified);
  EXPECT_NEAR(sliding.minClearance, gap, 1e-9);
  EXPECT_NEAR(sliding.provedClearance, 0.9 * gap, 1e-9);
  EXPECT_EQ(sliding.distanceQueries, 2U) << "those of its two configurations";
}

TEST_F(Certificate, ThePlaceBetweenTwoConfigurationsWhereAPathComesNearerIsMet) {
  build({boxBody("post", {0.2, 0.2, 4}, Pose::identity())},
        std::make_shared<const TriangleMesh>(makeBox({.2, .2, .2})));
  const MotionCertificate passing =
      certifyPath(*query, {Pose::translation({-3, 0.3, 0}), Pose::translation({3, 0.3, 0})}, kCertified);
  EXPECT_EQ(passing.status, CertificateStatus::Certified);
  EXPECT_LE(passing.provedClearance, 0.1);
  EXPECT_GE(passing.minClearance, 0.1 * (1.0 - 1e-9));
  const double most = kMostProvedShare * world->objectRadius();
  EXPECT_GE(passing.provedClearance, std::min(most, 0.9 * passing.minClearance) * (1.0 - 1e-9));
  EXPECT_NEAR(passing.at, 0.5, 0.1);
  EXPECT_NEAR(
      query->nearestObstacle(interpolate(Pose::translation({-3, 0.3, 0}), Pose::translation({3, 0.3, 0}), passing.at))
          .distance,
      passing.minClearance, 1e-12);
}

TEST_F(Certificate, OfARefusedPathTheEdgesBeforeKeepTheirDemandsAndTheRefusedOneProvesNothing) {
  build({boxBody("plane", {20, 20, 0.2}, Pose::translation({0, 0, -0.1}))}, makeL());
  const std::vector<Pose> path{Pose::translation({0, 0, 2}), Pose::translation({1, 0, 0.5}),
                               Pose::translation({2, 0, -1}), Pose::translation({2, 0, 1})};
  const MotionCertificate refused = certifyPath(*query, path, kCertified);
  ASSERT_EQ(refused.edges.size(), 2U);
  EXPECT_EQ(refused.edges[0].status, CertificateStatus::Certified);
  EXPECT_EQ(refused.edges[0].provedClearance, kCertified);
  EXPECT_NEAR(refused.edges[0].minClearance, 0.3, 1e-9);
  EXPECT_EQ(refused.edges[1].status, CertificateStatus::Violated);
  EXPECT_EQ(refused.edges[1].provedClearance, 0.0);
  EXPECT_LT(refused.edges[1].minClearance, kCertified);
}

TEST(MotionBound, BoundsEveryPointOfTheObject) {
  const MeshPtr object = makeL();
  RandomStream stream(5, "bound");
  for (int i = 0; i < 500; ++i) {
    const Pose from = randomPose(stream, 1.0);
    const Pose to = randomPose(stream, 1.0);
    const double bound = MotionBound(*object)(from, to);
    const double t0 = stream.uniform();
    const double t1 = stream.uniform();
    for (const Vector3& vertex : object->vertices) {
      const double moved = (interpolate(from, to, t1) * vertex - interpolate(from, to, t0) * vertex).norm();
      ASSERT_LE(moved, bound * std::abs(t1 - t0) * (1.0 + 1e-9) + 1e-12);
    }
  }
  EXPECT_DOUBLE_EQ(MotionBound(*object)(Pose::identity(), Pose::translation({0, 2, 0})), 2.0);
}

TEST_F(Certificate, FreeFractionStopsBeforeAPlateThickerThanItsStep) {
  build({boxBody("plate", {4, 4, 0.2}, Pose::identity())}, std::make_shared<const TriangleMesh>(makeBox({.1, .1, .1})));
  const Pose from = Pose::translation({0, 0, 2});
  const Pose to = Pose::translation({0, 0, -2});
  const double free = freeFraction(*query, from, to, 0.05);
  EXPECT_LT(free, 0.4625);
  EXPECT_GT(free, 0.4625 - 0.05 / 4.0 - 1e-9);
  EXPECT_FALSE(query->collides(interpolate(from, to, free)));
  EXPECT_EQ(freeFraction(*query, from, Pose::translation({1, 0, 2}), 0.05), 1.0);
  StopSource source;
  source.requestStop();
  EXPECT_EQ(freeFraction(*query, from, to, 0.05, source.token()), 0.0);
}

}  // namespace
}  // namespace glissade
