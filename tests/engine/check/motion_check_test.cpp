#include "tests/engine/support/independent_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/check/motion_check.h"
#include "engine/evidence/ray_containment.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

constexpr double kRequired = 1e-5;

MeshPtr cube(double edge) { return std::make_shared<const TriangleMesh>(makeBox(Vector3::Constant(edge))); }

MotionCertificate judge(const std::vector<RigidBody>& bodies, const TriangleMesh& object, const std::vector<Pose>& path,
                        double required = kRequired) {
  return IndependentCheck(bodies, object).check(path, std::vector<EdgeDemand>(path.size() - 1, {required, false}));
}

TEST(IndependentCheck, AgreesWithThePlannersCertificatesOnManyPaths) {
  Pose tilted;
  tilted.orientation = fromRollPitchYaw(0.4, -0.7, 0.2);
  const std::vector<RigidBody> bodies{boxBody("a", {1, 2, 0.5}, tilted),
                                      boxBody("b", {0.4, 0.4, 3}, Pose::translation({1.5, 0, 0}))};
  const MeshPtr object = makeL();
  const auto world = CollisionWorld::build(bodies, object);
  const auto query = world->makeQuery();
  const IndependentCheck check(bodies, *object);
  RandomStream stream(7, "paths");
  const double most = kMostProvedShare * radiusAboutOrigin(*object) * (1.0 - 1e-9);
  int certified = 0;
  for (int i = 0; i < 200; ++i) {
    const std::vector<Pose> path{randomPose(stream, 3.0), randomPose(stream, 3.0), randomPose(stream, 3.0)};
    const std::vector<EdgeDemand> demands(2, {kRequired, false});
    const MotionCertificate planners = certifyPath(*query, path, demands);
    const MotionCertificate judges = check.check(path, demands);
    ASSERT_EQ(judges.status, planners.status) << i;
    ASSERT_EQ(judges.edges.size(), planners.edges.size());
    if (judges.status != CertificateStatus::Certified) continue;
    ++certified;
    EXPECT_GE(planners.provedClearance, std::min(most, 0.89 * planners.minClearance));
    EXPECT_LE(planners.provedClearance, judges.minClearance * (1.0 + 1e-9));
    for (std::size_t edge = 0; edge < judges.edges.size(); ++edge) {
      const EdgeCertificate& a = judges.edges[edge];
      const EdgeCertificate& b = planners.edges[edge];
      // Both intervals contain the true clearance.
      EXPECT_LE(a.provedClearance, b.minClearance * (1.0 + 1e-9));
      EXPECT_LE(b.provedClearance, a.minClearance * (1.0 + 1e-9));
      EXPECT_GE(a.provedClearance, 0.49 * a.minClearance);
      EXPECT_GE(b.provedClearance, std::min(most, 0.49 * b.minClearance));
    }
  }
  EXPECT_GT(certified, 30);
  EXPECT_LT(certified, 170);
}

/// A cube slides over a floor and turns by 0.00001 radians, or not at all. Distances alone would need 60,000 queries.
TEST(MotionCheck, ANearlyStraightWayAlongAGapNeedsFewDistances) {
  constexpr double kGap = 5e-6;
  constexpr double kDemanded = 1e-6;
  const TriangleMesh object = makeBox(Vector3::Constant(0.1));
  const auto thin = std::make_shared<const TriangleMesh>(object);
  const auto floor = check::MotionCheck::prepare(makeBox({2.0, 2.0, 0.1}), Pose::translation({0.0, 0.0, -0.1}), 1.0);
  const check::MotionCheck judge({{floor, thin}}, object, 1.0);
  for (const double angle : {0.0, 1e-5, -1e-5}) {
    const Pose from = Pose::translation({-0.25, 0.0, kGap});
    Pose to = Pose::translation({0.25, 0.0, kGap});
    to.orientation = fromRollPitchYaw(0.0, angle, 0.0);
    const check::MotionVerdict verdict = judge.check({from, to}, {{kDemanded}});
    EXPECT_EQ(verdict.status, check::Status::Certified) << angle;
    EXPECT_LT(verdict.distances, 200U) << angle;
    // The lowest corner has come down by half the edge times the angle.
    const double least = kGap - 0.05 * std::abs(angle);
    EXPECT_LE(verdict.provedClearance, least * (1.0 + 1e-9));
    EXPECT_GT(verdict.provedClearance, 0.49 * least) << angle;
  }
  Pose low = Pose::translation({0.25, 0.0, kGap});
  low.orientation = fromRollPitchYaw(0.0, 1e-4, 0.0);
  EXPECT_EQ(judge.check({Pose::translation({-0.25, 0.0, kGap}), low}, {{kDemanded}}).status, check::Status::Violated);
}

/// A cube slides over a floor and passes between two posts, nearer to the first one than to the second one and to the
/// floor. The distances at both ends are those of the floor.
TEST(MotionCheck, TheNearestBodyOnAStraightWayIsNamed) {
  constexpr double kToFloor = 2e-4;
  constexpr double kToPost = 5e-5;
  const TriangleMesh object = makeBox(Vector3::Constant(0.1));
  const auto thin = std::make_shared<const TriangleMesh>(object);
  const auto floor = check::MotionCheck::prepare(makeBox({2.0, 2.0, 0.1}), Pose::translation({0.0, 0.0, -0.1}), 1.0);
  const auto post =
      check::MotionCheck::prepare(makeBox({0.05, 0.05, 0.3}), Pose::translation({0.0, 0.075 + kToPost, 0.16}), 1.0);
  const auto other = check::MotionCheck::prepare(makeBox({0.05, 0.05, 0.3}),
                                                 Pose::translation({0.0, -0.075 - 2.0 * kToPost, 0.16}), 1.0);
  const check::MotionCheck judge({{floor, thin}, {post, thin}, {other, thin}}, object, 1.0);
  const check::MotionVerdict verdict =
      judge.check({Pose::translation({-0.5, 0.0, kToFloor}), Pose::translation({0.5, 0.0, kToFloor})}, {{1e-6}});
  ASSERT_EQ(verdict.status, check::Status::Certified);
  EXPECT_NEAR(verdict.minClearance, kToPost, 1e-9);
  EXPECT_EQ(verdict.nearest.body, 1);
}

/// Tests the proof by sweeps: random motions along a gap with small turns about any axis. The heights of the corners
/// over the floor at 400 times confirm the certified clearance.
TEST(MotionCheck, NothingComesNearerThanIsProvedOnNearlyStraightWays) {
  RandomStream random(29, "ways");
  const TriangleMesh object = makeBox({0.08, 0.06, 0.04});
  const auto thin = std::make_shared<const TriangleMesh>(object);
  const auto floor = check::MotionCheck::prepare(makeBox({2.0, 2.0, 0.1}), Pose::translation({0.0, 0.0, -0.07}), 1.0);
  const check::MotionCheck judge({{floor, thin}}, object, 1.0);
  int certified = 0;
  int violated = 0;
  for (int round = 0; round < 120; ++round) {
    const double required = 1e-6;
    const auto place = [&] {
      Pose q = Pose::translation({random.uniform(-0.3, 0.3), random.uniform(-0.2, 0.2), random.uniform(1.5e-6, 8e-6)});
      const double most = std::pow(10.0, random.uniform(-8.0, -3.5));
      q.orientation =
          fromRollPitchYaw(random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most));
      return q;
    };
    const Pose from = place();
    const Pose to = place();
    const check::MotionVerdict verdict = judge.check({from, to}, {{required}});
    violated += verdict.status == check::Status::Violated ? 1 : 0;
    if (verdict.status != check::Status::Certified) continue;
    ++certified;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 400; ++i) {
      const double t = i / 400.0;
      Pose q;
      q.position = from.position + t * (to.position - from.position);
      q.orientation = from.orientation.slerp(t, to.orientation);
      for (const Vector3& corner : object.vertices) least = std::min(least, (q * corner).z() + 0.02);
    }
    EXPECT_GE(least, required) << round;
    EXPECT_LE(verdict.provedClearance, least * (1.0 + 1e-6)) << round;
  }
  EXPECT_GT(certified, 20);
  EXPECT_GT(violated, 10);
}

/// The scene in micrometres and in thousands of kilometres: scaling by a power of two changes no digit.
TEST(IndependentCheck, JudgeAndCertificateDecideAlikeAtEveryScale) {
  Pose tilted;
  tilted.orientation = fromRollPitchYaw(0.4, -0.7, 0.2);
  const std::vector<RigidBody> bodies{boxBody("a", {1, 2, 0.5}, tilted),
                                      boxBody("b", {0.4, 0.4, 3}, Pose::translation({1.5, 0, 0}))};
  const TriangleMesh object = *makeL();
  const auto resultsAt = [&](int exponent) {
    const double factor = std::ldexp(1.0, exponent);
    std::vector<RigidBody> placed = bodies;
    for (RigidBody& body : placed) {
      body.mesh = std::make_shared<const TriangleMesh>(scaled(*body.mesh, Vector3::Constant(factor)));
      body.X_WB.position *= factor;
    }
    const auto part = std::make_shared<const TriangleMesh>(scaled(object, Vector3::Constant(factor)));
    const auto query = CollisionWorld::build(placed, part)->makeQuery();
    const auto fclQuery = CollisionWorld::build(placed, part, CollisionBackend::Fcl)->makeQuery();
    const IndependentCheck check(placed, *part);
    RandomStream stream(11, "paths");
    std::vector<MotionCertificate> results;
    for (int i = 0; i < 60; ++i) {
      std::vector<Pose> path{randomPose(stream, 3.0), randomPose(stream, 3.0)};
      for (Pose& pose : path) pose.position *= factor;
      const std::vector<EdgeDemand> demands(1, {factor * kRequired, false});
      results.push_back(check.check(path, demands));
      results.push_back(certifyPath(*query, path, demands));
      EXPECT_EQ(results.back().status, results[results.size() - 2].status) << "2^" << exponent << ", path " << i;
      results.push_back(certifyMotion(*fclQuery, path[0], path[1], factor * kRequired));
    }
    return results;
  };
  const std::vector<MotionCertificate> expected = resultsAt(0);
  for (const int exponent : {-60, -30, -20, -10, 10, 20, 40}) {
    const std::vector<MotionCertificate> found = resultsAt(exponent);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(found[i].status, expected[i].status) << "2^" << exponent << ", result " << i;
      EXPECT_EQ(found[i].provedClearance, std::ldexp(expected[i].provedClearance, exponent));
      EXPECT_EQ(found[i].minClearance, std::ldexp(expected[i].minClearance, exponent));
      EXPECT_EQ(found[i].distanceQueries, expected[i].distanceQueries);
    }
  }
}

/// Coordinates beyond any scene give undecided or violated verdicts, and no stack overflow.
TEST(IndependentCheck, MotionsBeyondAllMeasureAreNotCertified) {
  const std::vector<RigidBody> bodies{boxBody("a", {1, 2, 0.5}, Pose::identity())};
  const auto query = CollisionWorld::build(bodies, makeL())->makeQuery();
  for (const double far : {1e15, 1e19, 1e25, 1e100, 1e200}) {
    const Pose from = Pose::translation({far, 0.3, 0.1});
    const Pose to = Pose::translation({-far, -0.1, 0.2});
    for (const auto seek : {SeekViolation::Any, SeekViolation::First}) {
      EXPECT_NE(query->checkMotion(from, to, kRequired, seek, {}).status, CertificateStatus::Certified) << far;
    }
  }
}

TEST(IndependentCheck, NothingTunnelsThroughAThinPlate) {
  const std::vector<RigidBody> plate{boxBody("plate", {4, 4, 1e-4}, Pose::identity())};
  const MotionCertificate through =
      judge(plate, *cube(0.01), {Pose::translation({0.3, 0.1, 3}), Pose::translation({-0.2, 0.4, -3.7})});
  EXPECT_EQ(through.status, CertificateStatus::Violated);
  EXPECT_EQ(through.nearest.body, 0);
  EXPECT_NEAR(through.at, 3.0 / 6.7, 0.01);
}

TEST(IndependentCheck, ATinyPenetrationIsSeenAndATinyGapCertified) {
  const std::vector<RigidBody> plane{boxBody("plane", {20, 20, 0.2}, Pose::translation({0, 0, -0.1}))};
  const auto slideAt = [&](double gap) {
    return judge(plane, *cube(0.4), {Pose::translation({-1, 0, 0.2 + gap}), Pose::translation({1, 0.3, 0.2 + gap})});
  };
  EXPECT_EQ(slideAt(-1e-6).status, CertificateStatus::Violated);
  EXPECT_EQ(slideAt(0.5e-5).status, CertificateStatus::Violated) << "free, but nearer than required";
  EXPECT_EQ(slideAt(1e-3).status, CertificateStatus::Certified);
}

TEST(IndependentCheck, AConfigurationMovedIntoAnObstacleIsNamed) {
  const std::vector<RigidBody> wall{boxBody("far", {1, 1, 1}, Pose::translation({0, 9, 0})),
                                    boxBody("wall", {1, 1, 1}, Pose::identity())};
  std::vector<Pose> path{Pose::translation({-3, 2, 0}), Pose::translation({0, 2, 0}), Pose::translation({3, 2, 0})};
  ASSERT_EQ(judge(wall, *cube(0.4), path).status, CertificateStatus::Certified);
  path[1].position.y() = 0.6;
  const MotionCertificate corrupted = judge(wall, *cube(0.4), path);
  EXPECT_EQ(corrupted.status, CertificateStatus::Violated);
  EXPECT_EQ(corrupted.edge, 0U);
  EXPECT_EQ(corrupted.nearest.body, 1);
}

TEST(IndependentCheck, ContainmentCountsBothWays) {
  const std::vector<RigidBody> large{boxBody("large", {4, 4, 4}, Pose::identity())};
  EXPECT_EQ(judge(large, *cube(0.2), {Pose::identity(), Pose::translation({0.1, 0, 0})}).status,
            CertificateStatus::Violated);
  const std::vector<RigidBody> small{boxBody("small", {0.1, 0.1, 0.1}, Pose::identity())};
  EXPECT_EQ(judge(small, *cube(2.0), {Pose::identity(), Pose::translation({0.1, 0, 0})}).status,
            CertificateStatus::Violated);
}

TEST(IndependentCheck, AStopLeavesItUndecidedAndSoDoesATurnOfHalfACircle) {
  const std::vector<RigidBody> plane{boxBody("plane", {1, 1, 1}, Pose::translation({9, 0, 0}))};
  StopSource source;
  source.requestStop();
  const IndependentCheck check(plane, *cube(0.2));
  const std::vector<EdgeDemand> demands{{kRequired, false}};
  EXPECT_EQ(check.check({Pose::identity(), Pose::translation({1, 0, 0})}, demands, source.token()).status,
            CertificateStatus::Undecided);
  Pose turned;
  turned.orientation = Quaternion(0.0, 0.0, 0.0, 1.0);
  EXPECT_EQ(check.check({Pose::identity(), turned}, demands).status, CertificateStatus::Undecided);
  EXPECT_EQ(toString(check.whyUndecided(Pose::identity(), turned, kRequired)).find("the edge turns by half a circle"),
            0U);
}

TEST(IndependentCheck, CoordinatesThatHideTheClearanceAreTheReason) {
  const Pose far = Pose::translation({1e12, 0, 0});
  const std::vector<RigidBody> plane{boxBody("plane", {1, 1, 1}, Pose::translation({9, 0, 0}))};
  const IndependentCheck check(plane, *cube(0.2));
  const Pose beside = Pose::translation({1e12, 1, 0});
  EXPECT_EQ(check.check({far, beside}, {{kRequired, false}}).status, CertificateStatus::Undecided);
  EXPECT_EQ(toString(check.whyUndecided(far, beside, kRequired)).find("the rounding of coordinates"), 0U);
  EXPECT_EQ(check.check({far, beside}, {{1.0, false}}).status, CertificateStatus::Certified);
}

TEST(RaySolid, AgreesWithWhatIsInsideByConstruction) {
  TriangleMesh hollow = makeBox({2, 2, 2});
  TriangleMesh cavity = makeBox({1, 1, 1});
  for (TriangleIndices& corners : cavity.triangles) std::swap(corners[0], corners[1]);
  append(hollow, cavity);
  const evidence::RaySolid shell(hollow);
  EXPECT_EQ(shell.partPoints().size(), 2U);
  TriangleMesh overlapping = makeBox({2, 2, 2});
  append(overlapping, transformed(makeBox({2, 2, 2}), Pose::translation({1, 0, 0})));
  const evidence::RaySolid both(overlapping);
  RandomStream stream(3, "points");
  for (int i = 0; i < 500; ++i) {
    const Vector3 p = randomPose(stream, 2.0).position;
    const double reach = p.cwiseAbs().maxCoeff();
    EXPECT_EQ(shell.contains(p), reach < 1.0 && reach > 0.5);
    const double second = (p - Vector3(1, 0, 0)).cwiseAbs().maxCoeff();
    EXPECT_EQ(both.contains(p), reach < 1.0 || second < 1.0);
  }
  EXPECT_TRUE(both.contains(Vector3::Zero())) << "rays through edges are drawn anew";
  TriangleMesh open = makeBox({2, 2, 2});
  open.triangles.pop_back();
  EXPECT_FALSE(evidence::RaySolid(open).contains(Vector3(0.1, 0.2, 0.3)));
}

}  // namespace
}  // namespace glissade
