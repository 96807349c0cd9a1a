#include "engine/collision/collision_query.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "engine/collision/motion_certificate.h"
#include "tests/engine/collision/exact_reference.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

/// Worlds that are small enough for the reference and difficult in different ways.
struct Case {
  const char* name;
  std::vector<RigidBody> obstacles;
  MeshPtr object;
  double reach;  ///< half width of the cube in which poses are drawn
  Vector3 origin = Vector3::Zero();
};

MeshPtr boxMesh(const Vector3& size) { return std::make_shared<const TriangleMesh>(makeBox(size)); }

std::vector<Case> cases() {
  Pose tilted;
  tilted.orientation = fromRollPitchYaw(0.4, -0.7, 0.2);
  RigidBody bar = boxBody("bar", Vector3::Ones(), tilted);
  bar.mesh = std::make_shared<const TriangleMesh>(makeCylinder(0.3, 2.0, 8));
  return {
      {"L among boxes",
       {boxBody("a", {1, 2, 0.5}, tilted), boxBody("b", {0.4, 0.4, 3}, Pose::identity())},
       makeL(),
       2.0},
      {"L and a bar", {bar}, makeL(), 2.0},
      {"thin plate", {boxBody("plate", {3, 3, 0.001}, Pose::identity())}, boxMesh({0.5, 0.5, 0.5}), 1.0},
      {"axis-parallel boxes", {boxBody("a", Vector3::Ones(), Pose::identity())}, boxMesh(Vector3::Ones()), 1.2},
      {"small in large", {boxBody("large", {4, 4, 4}, tilted)}, boxMesh({0.3, 0.2, 0.4}), 3.0},
      {"large around small", {boxBody("small", {0.3, 0.2, 0.4}, tilted)}, boxMesh({2, 2, 2}), 2.0},
      {"far from the origin",
       {boxBody("a", {1, 2, 0.5}, Pose::translation({500, -300, 200}))},
       makeL(),
       2.0,
       {500, -300, 200}},
  };
}

Pose randomPoseIn(const Case& world, RandomStream& stream) {
  Pose q = randomPose(stream, world.reach);
  q.position += world.origin;
  // Many configurations that people make are axis-parallel, where faces are coplanar.
  if (stream.uniform() < 0.3) q.orientation = fromRollPitchYaw(std::floor(stream.uniform(0, 4)) * std::acos(0.0), 0, 0);
  return q;
}

/// Both backends answer the same queries.
class CollisionQueryBy : public testing::TestWithParam<CollisionBackend> {};

TEST_P(CollisionQueryBy, AgreesWithExactPredicatesOnRandomPoses) {
  for (const Case& world : cases()) {
    const auto query = CollisionWorld::build(world.obstacles, world.object, GetParam())->makeQuery();
    RandomStream stream(1, world.name);
    int colliding = 0;
    for (int i = 0; i < 1000; ++i) {
      const Pose q = randomPoseIn(world, stream);
      const bool expected = reference::collides(world.obstacles, *world.object, q);
      colliding += expected ? 1 : 0;
      ASSERT_EQ(query->collides(q), expected) << world.name << ", pose " << i;
      ASSERT_EQ(query->collidingBody(q).has_value(), expected) << world.name << ", pose " << i;
      ASSERT_EQ(query->nearestObstacle(q).distance <= 0.0, expected) << world.name << ", pose " << i;
    }
    EXPECT_GT(colliding, 20) << world.name;
    EXPECT_LT(colliding, 980) << world.name;
  }
}

TEST_P(CollisionQueryBy, AgreesWithExactPredicatesWhereItNearlyTouches) {
  for (const Case& world : cases()) {
    const auto query = CollisionWorld::build(world.obstacles, world.object, GetParam())->makeQuery();
    RandomStream stream(2, world.name);
    int tested = 0;
    for (int i = 0; i < 400 && tested < 60; ++i) {
      Pose free = randomPoseIn(world, stream);
      Pose touching = randomPoseIn(world, stream);
      if (query->collides(free) || !query->collides(touching)) continue;
      for (int step = 0; step < 40; ++step) {
        const Pose middle = interpolate(free, touching, 0.5);
        (query->collides(middle) ? touching : free) = middle;
      }
      for (const double offset : {0.0, 1e-9, 1e-7, 1e-5, 1e-3}) {
        for (const Pose& base : {free, touching}) {
          Pose q = base;
          q.position += offset * Vector3(stream.normal(), stream.normal(), stream.normal());
          ASSERT_EQ(query->collides(q), reference::collides(world.obstacles, *world.object, q))
              << world.name << ", bisection " << i << ", offset " << offset;
        }
      }
      ++tested;
    }
    EXPECT_GT(tested, 10) << world.name;
  }
}

TEST_P(CollisionQueryBy, DistanceAndNearestPointsAgreeWithEveryPairOfTriangles) {
  for (const Case& world : cases()) {
    const auto query = CollisionWorld::build(world.obstacles, world.object, GetParam())->makeQuery();
    RandomStream stream(3, world.name);
    for (int i = 0; i < 300; ++i) {
      const Pose q = randomPoseIn(world, stream);
      if (reference::collides(world.obstacles, *world.object, q)) continue;
      const NearestObstacle nearest = query->nearestObstacle(q);
      const double expected = reference::surfaceDistance(world.obstacles, *world.object, q);
      const double scale = 1.0 + world.origin.norm();
      ASSERT_NEAR(nearest.distance, expected, 1e-9 * scale) << world.name << ", pose " << i;
      ASSERT_NEAR((nearest.p_WPn - nearest.p_WPo).norm(), expected, 1e-9 * scale);
      const RigidBody& body = world.obstacles[static_cast<std::size_t>(nearest.body)];
      EXPECT_LT(reference::pointDistance(transformed(*body.mesh, body.X_WB), nearest.p_WPo), 1e-9 * scale);
      EXPECT_LT(reference::pointDistance(transformed(*world.object, q), nearest.p_WPn), 1e-9 * scale);
    }
  }
}

TEST_P(CollisionQueryBy, AHollowOpenMeshContainsNothing) {
  RigidBody open = boxBody("open", {4, 4, 4}, Pose::identity());
  TriangleMesh mesh = *open.mesh;
  mesh.triangles.pop_back();
  open.mesh = std::make_shared<const TriangleMesh>(mesh);
  const auto query = CollisionWorld::build({open}, boxMesh({0.2, 0.2, 0.2}), GetParam())->makeQuery();
  EXPECT_FALSE(query->collides(Pose::identity()));
}

TEST_P(CollisionQueryBy, EveryPartOfABodyIsSolid) {
  // Two boxes in one mesh, the object inside the second.
  TriangleMesh two = makeBox(Vector3::Ones());
  append(two, transformed(makeBox({2, 2, 2}), Pose::translation({5, 0, 0})));
  RigidBody body = boxBody("two", Vector3::Ones(), Pose::identity());
  body.mesh = std::make_shared<const TriangleMesh>(two);
  const auto query = CollisionWorld::build({body}, boxMesh({0.1, 0.1, 0.1}), GetParam())->makeQuery();
  EXPECT_TRUE(query->collides(Pose::translation({5, 0.3, 0})));
  EXPECT_TRUE(query->collides(Pose::translation({0, 0.3, 0})));
  EXPECT_FALSE(query->collides(Pose::translation({2.5, 0, 0})));
}

TEST_P(CollisionQueryBy, WithoutObstaclesEverythingIsFree) {
  const auto query = CollisionWorld::build({}, makeL(), GetParam())->makeQuery();
  EXPECT_FALSE(query->collides(Pose::identity()));
  EXPECT_FALSE(query->collidingBody(Pose::identity()));
  EXPECT_TRUE(std::isinf(query->nearestObstacle(Pose::identity()).distance));
  EXPECT_EQ(query->nearestObstacle(Pose::identity()).body, -1);
}

TEST_P(CollisionQueryBy, TheLowestCollidingBodyIsNamed) {
  const auto query = CollisionWorld::build({boxBody("away", Vector3::Ones(), Pose::translation({9, 0, 0})),
                                            boxBody("hit", Vector3::Ones(), Pose::identity()),
                                            boxBody("hit too", Vector3::Ones(), Pose::identity())},
                                           makeL(), GetParam())
                         ->makeQuery();
  EXPECT_EQ(query->collidingBody(Pose::identity()), 1);
}

TEST_P(CollisionQueryBy, ThreadsWithAQueryEachGetTheSameAnswers) {
  const Case world = cases().front();
  const auto shared = CollisionWorld::build(world.obstacles, world.object, GetParam());
  const auto answers = [&] {
    const auto query = shared->makeQuery();
    RandomStream stream(4, "threads");
    std::vector<double> distances;
    for (int i = 0; i < 2000; ++i) distances.push_back(query->nearestObstacle(randomPoseIn(world, stream)).distance);
    return distances;
  };
  const std::vector<double> expected = answers();
  std::vector<std::vector<double>> found(3);
  std::vector<std::thread> threads;
  for (auto& result : found) threads.emplace_back([&] { result = answers(); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& result : found) EXPECT_EQ(result, expected);
}

TEST_P(CollisionQueryBy, CountsItsQueries) {
  const auto query = CollisionWorld::build({}, makeL(), GetParam())->makeQuery();
  query->collides(Pose::identity());
  query->nearestObstacle(Pose::identity());
  query->nearestObstacle(Pose::identity());
  EXPECT_EQ(query->counts().collision, 1U);
  EXPECT_EQ(query->counts().distance, 2U);
}

TEST_P(CollisionQueryBy, BoundedDistancesAreThoseOfTheNearestObstacle) {
  for (const Case& world : cases()) {
    const auto query = CollisionWorld::build(world.obstacles, world.object, GetParam())->makeQuery();
    RandomStream stream(5, world.name);
    for (int i = 0; i < 300; ++i) {
      const Pose q = randomPoseIn(world, stream);
      const double distance = query->nearestObstacle(q).distance;
      const double bound = stream.uniform(0.0, 2.0);
      EXPECT_NEAR(query->distanceUpTo(q, bound), std::min(distance, bound), 1e-12 * (1.0 + world.origin.norm()));
      if (std::abs(distance - bound) < 1e-9) continue;
      EXPECT_EQ(query->clearAbove(q, bound), distance > bound) << world.name << ", pose " << i;
    }
  }
}

TEST_P(CollisionQueryBy, AMotionThatItCallsFreeIsFreeAndAViolationIsOne) {
  constexpr double kRequired = 1e-3;
  for (const Case& world : cases()) {
    const auto query = CollisionWorld::build(world.obstacles, world.object, GetParam())->makeQuery();
    RandomStream stream(6, world.name);
    int certified = 0;
    int violated = 0;
    for (int i = 0; i < 300; ++i) {
      const Pose from = randomPoseIn(world, stream);
      Pose to = randomPoseIn(world, stream);
      if (stream.uniform() < 0.5) to = interpolate(from, to, 0.1);
      const MotionCheck check = query->checkMotion(from, to, kRequired, SeekViolation::First, {});
      ASSERT_NE(check.status, CertificateStatus::Undecided);
      const bool isFree = check.status == CertificateStatus::Certified;
      const MotionCheck any = query->checkMotion(from, to, kRequired, SeekViolation::Any, {});
      ASSERT_EQ(any.status, check.status) << world.name << ", motion " << i;
      ++(isFree ? certified : violated);
      for (int k = 0; k < 20 && check.certified > 0.0; ++k) {
        const Pose q = interpolate(from, to, check.certified * stream.uniform());
        ASSERT_FALSE(reference::collides(world.obstacles, *world.object, q)) << world.name << ", motion " << i;
        ASSERT_GE(query->nearestObstacle(q).distance, kRequired * (1.0 - 1e-6)) << world.name << ", motion " << i;
      }
      if (isFree) continue;
      EXPECT_LT(query->nearestObstacle(interpolate(from, to, check.at)).distance, kRequired * 1.002);
      EXPECT_LT(query->nearestObstacle(interpolate(from, to, any.at)).distance, kRequired * 1.002);
    }
    EXPECT_GT(certified, 10) << world.name;
    EXPECT_GT(violated, 10) << world.name;
  }
}

/// Rounding is larger than the bodies there; such motions were reported as free.
TEST_P(CollisionQueryBy, MotionsBeyondAllMeasureEndAndAreNotCalledFree) {
  for (const Case& world : cases()) {
    const auto query = CollisionWorld::build(world.obstacles, world.object, GetParam())->makeQuery();
    for (const double far : {1e19, 1e30, 1e150, 1e300}) {
      for (const SeekViolation seek : {SeekViolation::First, SeekViolation::Any}) {
        const Pose from = Pose::translation({-far, 0.0, 0.0});
        const Pose to = Pose::translation({far, 0.0, 0.0});
        EXPECT_NE(query->checkMotion(from, to, 1e-3, seek, {}).status, CertificateStatus::Certified)
            << world.name << ", " << far;
        EXPECT_LT(freeFraction(*query, from, to, 0.01), 1.0);
      }
    }
  }
}

/// Bodies are added, removed and moved, and the object changes. Answers do not depend on earlier preparation.
TEST_P(CollisionQueryBy, AnUpdatedWorldAnswersAsOneThatIsBuiltAnew) {
  RandomStream stream(11, "updated");
  const auto obstacle = [](int i) {
    return boxBody("b" + std::to_string(i), {0.3 + 0.1 * i, 0.4, 0.5}, Pose::translation({1.0 * i, 0, 0}));
  };
  std::vector<RigidBody> obstacles{obstacle(0), obstacle(1), obstacle(2)};
  MeshPtr object = makeL();
  CollisionWorldPtr updated = CollisionWorld::build(obstacles, object, GetParam());
  for (int edit = 0; edit < 12; ++edit) {
    const auto body = static_cast<std::size_t>(3.0 * stream.uniform());
    if (edit % 4 == 0) obstacles[body].X_WB.position += Vector3(0.1, 0.2, -0.1);
    if (edit % 4 == 1) obstacles[body] = obstacle(edit);
    if (edit % 4 == 2) object = boxMesh({0.2, 0.3, 0.1 * edit});
    if (edit % 4 == 3) obstacles[body].name = "renamed";
    updated = updated->updated(obstacles, object);
    const CollisionWorldPtr anew = CollisionWorld::build(obstacles, object, GetParam());
    ASSERT_EQ(updated->obstacles()[body].name, anew->obstacles()[body].name);
    ASSERT_EQ(updated->objectRadius(), anew->objectRadius());
    const auto mine = updated->makeQuery();
    const auto other = anew->makeQuery();
    for (int i = 0; i < 100; ++i) {
      const Pose q = randomPose(stream, 2.0);
      ASSERT_EQ(mine->collidingBody(q), other->collidingBody(q)) << edit;
      const NearestObstacle a = mine->nearestObstacle(q);
      const NearestObstacle b = other->nearestObstacle(q);
      ASSERT_EQ(a.distance, b.distance) << edit;
      ASSERT_EQ(a.body, b.body) << edit;
      ASSERT_EQ(a.p_WPo, b.p_WPo) << edit;
      const Pose to = randomPose(stream, 2.0);
      const MotionCheck one = mine->checkMotion(q, to, 1e-3, SeekViolation::First, {});
      const MotionCheck two = other->checkMotion(q, to, 1e-3, SeekViolation::First, {});
      ASSERT_EQ(one.status, two.status) << edit;
      ASSERT_EQ(one.certified, two.certified) << edit;
      ASSERT_EQ(one.at, two.at) << edit;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, CollisionQueryBy, testing::Values(CollisionBackend::Kernel, CollisionBackend::Fcl),
                         [](const auto& backend) {
                           return backend.param == CollisionBackend::Kernel ? "Kernel" : "Fcl";
                         });

}  // namespace
}  // namespace glissade
