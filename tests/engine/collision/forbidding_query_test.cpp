#include "engine/collision/forbidding_query.h"

#include <gtest/gtest.h>

#include "engine/collision/motion_certificate.h"
#include "engine/geometry/screw_axis.h"
#include "tests/engine/support/forbidden_boxes.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

constexpr double kMargin = 1e-4;
/// Largest margin that is accepted.
constexpr double kAtMost = 1.02 * kMargin;

ForbiddenPlaces someBoxes(RandomStream& stream, int count) {
  ForbiddenPlaces places{{"P1", {}}, {"P2", {}}};
  for (int i = 0; i < count; ++i) {
    const Vector3 centre = randomPose(stream, 1.5).position;
    const Vector3 half(stream.uniform(0.05, 0.4), stream.uniform(0.05, 0.4), stream.uniform(0.05, 0.4));
    places[static_cast<std::size_t>(i % 2)].boxes.emplace_back(centre - half, centre + half);
  }
  return places;
}

std::shared_ptr<ForbiddenSpace> spaceOf(const ForbiddenPlaces& places) {
  auto space = std::make_shared<ForbiddenSpace>();
  space->set(std::make_shared<const ForbiddenRegions>(places, kMargin));
  return space;
}

void expectAsExact(const ForbiddenPlaces& places, const Pose& a, const Pose& b) {
  const ForbiddenRegions regions(places, kMargin);
  const bool meets = regions.firstOn(a.position, b.position).has_value();
  if (!test::metBy({a, b}, places, kMargin).empty()) {
    EXPECT_TRUE(meets);
  } else if (test::metBy({a, b}, places, kAtMost).empty()) {
    EXPECT_FALSE(meets);
  }
}

TEST(ForbiddenRegions, SegmentsMeetThemAsExactClippingSays) {
  RandomStream stream(1, "segments");
  for (int round = 0; round < 20; ++round) {
    const ForbiddenPlaces places = someBoxes(stream, 4);
    for (int i = 0; i < 50; ++i) expectAsExact(places, randomPose(stream, 2.0), randomPose(stream, 2.0));
  }
}

/// Most of these segments touch a face, an edge or a corner, or go along one.
TEST(ForbiddenRegions, TouchingIsForbiddenWhereNumbersCoincide) {
  constexpr int kMost = 3;
  RandomStream stream(2, "touching segments");
  for (int i = 0; i < 4000; ++i) {
    const ForbiddenPlaces places{{"P1", {test::latticeBox(stream, kMost)}}};
    const Pose a = Pose::translation(test::latticePoint(stream, kMost));
    const Pose b = Pose::translation(test::latticePoint(stream, kMost));
    expectAsExact(places, a, b);
    EXPECT_EQ(ForbiddenRegions(places, kMargin).holding(a.position).has_value(),
              !test::metBy({a}, places, kMargin).empty());
  }
}

TEST(ForbiddenRegions, AreClosed) {
  const ForbiddenRegions regions({{"P1", {Box3(Vector3::Zero(), Vector3::Ones())}}}, kMargin);
  EXPECT_TRUE(regions.holding({1.0, 0.5, 0.5}));
  EXPECT_TRUE(regions.holding({1.0 + kMargin, 0.5, 0.5}));
  EXPECT_FALSE(regions.holding({1.0 + kAtMost, 0.5, 0.5}));
  EXPECT_FALSE(regions.isInside(0, {1.0, 0.5, 0.5}));
  EXPECT_TRUE(regions.isInside(0, {0.999, 0.5, 0.5}));
  EXPECT_TRUE(regions.firstOn({1.0, -1.0, 0.5}, {1.0, 2.0, 0.5})) << "along a face";
  EXPECT_TRUE(regions.firstOn({2.0, 0.5, 0.5}, {1.0, 0.5, 0.5})) << "up to a face";
  EXPECT_TRUE(regions.firstOn({-1.0, 1.0, 1.0}, {2.0, 1.0, 1.0})) << "along an edge";
  EXPECT_TRUE(regions.firstOn({0.0, 2.0, 1.0}, {2.0, 0.0, 1.0})) << "through a corner";
  const auto through = regions.firstOn({-1.0, 0.5, 0.5}, {3.0, 0.5, 0.5});
  ASSERT_TRUE(through);
  EXPECT_NEAR(through->begin, 0.25, kMargin);
  EXPECT_NEAR(through->end, 0.5, kMargin);
}

TEST(ForbiddingQuery, NoAnswerLetsTheReferencePointIn) {
  const Problem problem = windowProblem();
  RandomStream stream(2, "answers");
  const ForbiddenPlaces places = someBoxes(stream, 8);
  const ForbiddenRegions regions(places, kMargin);
  const auto world = problem.world->withForbidden(spaceOf(places));
  const auto query = world->makeQuery();
  const auto bodies = problem.world->makeQuery();
  for (int i = 0; i < 500; ++i) {
    const Pose a = randomPose(stream, 1.9);
    const Pose b = randomPose(stream, 1.9);
    const bool inside = regions.holding(a.position).has_value();
    EXPECT_EQ(query->collides(a), inside || bodies->collides(a));
    EXPECT_EQ(query->clearAbove(a, 1e-4), !inside && bodies->clearAbove(a, 1e-4));
    if (inside) {
      EXPECT_EQ(query->nearestObstacle(a).distance, 0.0);
    }
    if (!inside) {
      EXPECT_EQ(query->nearestObstacle(a).distance, bodies->nearestObstacle(a).distance);
    }
    const bool enters = regions.firstOn(a.position, b.position).has_value();
    for (const SeekViolation seek : {SeekViolation::Any, SeekViolation::First}) {
      const MotionCheck check = query->checkMotion(a, b, 1e-4, seek, {});
      const MotionCheck alone = bodies->checkMotion(a, b, 1e-4, seek, {});
      if (!enters) {
        EXPECT_EQ(check.status, alone.status);
      }
      if (enters) {
        EXPECT_EQ(check.status, CertificateStatus::Violated);
      }
    }
    EXPECT_EQ(certifyMotion(*query, a, b, 1e-4).status == CertificateStatus::Certified,
              !enters && certifyMotion(*bodies, a, b, 1e-4).status == CertificateStatus::Certified);
    if (inside || bodies->collides(a)) continue;
    const Pose reached = interpolate(a, b, freeFraction(*query, a, b, 0.05));
    EXPECT_EQ(test::metBy({a, reached}, places, kMargin), "");
  }
}

TEST(ForbiddingQuery, WorldsThatAreMadeOfAWorldKeepWhatIsForbidden) {
  const Problem problem = windowProblem();
  const ForbiddenPlaces places{{"P1", {Box3(Vector3(-0.5, -0.5, -0.5), Vector3(0.5, 0.5, 0.5))}}};
  const auto space = spaceOf(places);
  const auto world = problem.world->withForbidden(space);
  const auto object = std::make_shared<const TriangleMesh>(makeBox({0.1, 0.1, 0.1}));
  const Pose inside = Pose::identity();
  ASSERT_FALSE(problem.world->makeQuery()->collides(inside));
  for (const CollisionWorldPtr& made :
       {world, world->withObject(object), world->withBackend(CollisionBackend::Fcl),
        world->withObjects([&](const TriangleMesh&) { return object; }), world->withVariants({{object, {0}}}),
        world->updated(world->obstacles(), object)}) {
    EXPECT_TRUE(made->makeQuery()->collides(inside));
    EXPECT_EQ(made->makeQuery()->collidingBody(inside), kForbiddenPlace);
  }
  const auto query = world->makeQuery();
  space->set(nullptr);
  EXPECT_FALSE(query->collides(inside)) << "queries follow at once";
  EXPECT_EQ(world->forbidden(), nullptr);
}

TEST(ForbiddingQuery, AScrewMotionThroughAPlaceIsNotShownToBeFree) {
  const CollisionWorldPtr plain =
      CollisionWorld::build({boxBody("far", {0.1, 0.1, 0.1}, Pose::translation({0.0, 0.0, -2.0}))},
                            std::make_shared<const TriangleMesh>(makeBox({0.1, 0.1, 0.1})));
  const ScrewAxis screw{Vector3::Zero(), Vector3::UnitZ(), 0.2};
  const Pose from = Pose::translation({0.5, 0.0, 0.0});
  const auto at = [&](const Vector3& centre) {
    const Vector3 half = Vector3::Constant(0.02);
    return plain->withForbidden(spaceOf({{"P1", {Box3(centre - half, centre + half)}}}))->makeQuery();
  };
  const double alone = plain->makeQuery()->screwClearance(from, screw, 0.6, 0.5, 0.0);
  ASSERT_GT(alone, 0.0);
  EXPECT_EQ(at(screwed(screw, from, 0.35).position)->screwClearance(from, screw, 0.6, 0.5, 0.0), 0.0);
  EXPECT_EQ(at({0.0, 0.0, 0.3})->screwClearance(from, screw, 0.6, 0.5, 0.0), alone) << "on the axis";
}

}  // namespace
}  // namespace glissade
