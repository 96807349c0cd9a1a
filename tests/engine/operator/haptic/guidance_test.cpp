#include "engine/operator/guidance.h"

#include <gtest/gtest.h>

#include "engine/operator/hand_guide.h"
#include "engine/operator/reachable_ahead.h"
#include "tests/engine/support/forbidden_boxes.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

NearestObstacle floorBelow(const Pose& q, double gap) {
  NearestObstacle nearest;
  nearest.body = 0;
  nearest.distance = gap;
  nearest.p_WPn = q.position + Vector3(0.5, 0.0, 0.0);
  nearest.p_WPo = nearest.p_WPn - Vector3(0.0, 0.0, gap);
  return nearest;
}

TEST(Repulsion, PushesAwaySmoothlyAndNoHarderThanItsStrength) {
  const Guidance guidance{0.7, 0.0, 0.2, std::nullopt};
  double last = 0.0;
  for (double gap = 0.25; gap > 1e-3; gap -= 1e-3) {
    const Wrench wrench = repulsion(guidance, Pose(), floorBelow(Pose(), gap), 1.0);
    const double strength = wrench.force_W.z();
    EXPECT_EQ(wrench.force_W.norm(), strength);
    EXPECT_GE(strength, last);
    EXPECT_LT(strength - last, 0.01);
    EXPECT_LT(strength, 0.7);
    EXPECT_EQ(strength > 0.0, gap < 0.2);
    EXPECT_NEAR(wrench.torque_W.y(), -0.5 * strength, 1e-12);
    last = strength;
  }
  EXPECT_GT(last, 0.65);
}

TEST(Repulsion, IsNothingWithoutADirection) {
  const Guidance guidance{1.0, 0.0, 0.2, std::nullopt};
  EXPECT_TRUE(repulsion(guidance, Pose(), NearestObstacle(), 1.0).isZero());
  EXPECT_TRUE(repulsion(guidance, Pose(), floorBelow(Pose(), 0.0), 1.0).isZero());
}

TEST(Attraction, DrawsToTheTargetAndIsCapped) {
  RandomStream stream(1, "poses");
  for (int i = 0; i < 1000; ++i) {
    const Pose target = randomPose(stream, 3.0);
    const Pose q = randomPose(stream, 3.0);
    const Wrench wrench = attraction({0.0, 0.4, 0.2, target}, q, 0.7);
    EXPECT_LE(wrench.force_W.norm(), 0.4);
    EXPECT_LE(wrench.torque_W.norm(), 0.4);
    EXPECT_GT(wrench.force_W.dot(target.position - q.position), 0.0);
    EXPECT_TRUE(attraction({0.0, 0.4, 0.2, target}, target, 0.7).isZero());
  }
  EXPECT_TRUE(attraction({0.0, 0.4, 0.2, std::nullopt}, Pose(), 0.7).isZero());
}

TEST(AheadOnWay, RunsAheadOfTheNearestPointAndStopsAtTheEnd) {
  const std::vector<Pose> way{Pose::translation({0, 0, 0}), Pose::translation({1, 0, 0}), Pose::translation({1, 1, 0})};
  const Se3Metric metric(1.0);
  const auto at = [&](const Vector3& p, double ahead) { return aheadOnWay(way, Pose::translation(p), metric, ahead); };
  EXPECT_TRUE(at({0.25, 0.1, 0.0}, 0.5)->position.isApprox(Vector3(0.75, 0.0, 0.0)));
  EXPECT_TRUE(at({0.75, -0.1, 0.0}, 0.5)->position.isApprox(Vector3(1.0, 0.25, 0.0)));
  EXPECT_TRUE(at({2.0, 0.8, 0.0}, 0.5)->position.isApprox(Vector3(1.0, 1.0, 0.0)));
  EXPECT_FALSE(aheadOnWay({}, Pose(), metric, 0.5));
  EXPECT_EQ(*aheadOnWay({way[1]}, Pose(), metric, 0.5), way[1]);
}

/// A channel with two bends between boxes, and a way along its middle.
struct Channel {
  std::vector<Box3> walls{{Vector3(-0.5, 0.2, -1), Vector3(1.8, 2.2, 1)},
                          {Vector3(2.2, -0.5, -1), Vector3(3, 2, 1)},
                          {Vector3(-0.5, -1, -1), Vector3(3, -0.2, 1)}};
  std::vector<Pose> way{Pose::translation({0, 0, 0}), Pose::translation({2, 0, 0}), Pose::translation({2, 2.4, 0}),
                        Pose::translation({4, 2.4, 0})};

  CollisionWorldPtr world() const {
    std::vector<RigidBody> bodies;
    for (const Box3& wall : walls) bodies.push_back(boxBody("wall", wall.sizes(), Pose::translation(wall.center())));
    return CollisionWorld::build(bodies, std::make_shared<const TriangleMesh>(makeBox({0.3, 0.3, 0.3})));
  }
};

TEST(AheadInSight, TheLineToItMeetsNoWall) {
  const Channel channel;
  const CollisionWorldPtr world = channel.world();
  const auto sight = pointWorld(*world)->makeQuery();
  const Se3Metric metric(world->objectRadius());
  RandomStream stream(1, "hands");
  int around = 0;
  for (int i = 0; i < 2000; ++i) {
    Pose q = randomPose(stream, 0.9);
    q.position += Vector3(2.0, 1.0, 0.0);
    const auto meetsWall = [&](const Pose& to) {
      return std::any_of(channel.walls.begin(), channel.walls.end(),
                         [&](const Box3& wall) { return test::meetsBox(q.position, to.position, wall, 0.0); });
    };
    if (meetsWall(q)) continue;
    const double ahead = stream.uniform(0.1, 3.0);
    const auto target = aheadInSight(channel.way, q, metric, ahead, *sight);
    ASSERT_TRUE(target);
    EXPECT_FALSE(meetsWall(*target));
    around += meetsWall(*aheadOnWay(channel.way, q, metric, ahead)) ? 1 : 0;
  }
  EXPECT_GT(around, 50);
}

TEST(AheadInSight, BehindAWallNothingIsInSight) {
  const Channel channel;
  const CollisionWorldPtr world = channel.world();
  const auto sight = pointWorld(*world)->makeQuery();
  const Se3Metric metric(world->objectRadius());
  EXPECT_FALSE(aheadInSight(channel.way, Pose::translation({1.0, -1.5, 0.0}), metric, 0.5, *sight));
  // A hub's reference point may be in the axle that it turns on.
  EXPECT_TRUE(aheadInSight(channel.way, Pose::translation({1.0, -0.5, 0.0}), metric, 0.5, *sight));
}

/// The cube in the channel is turned, so that it gets around the corner in small steps only.
TEST(ReachableAhead, TheObjectGetsThereOrSlides) {
  const Channel channel;
  const CollisionWorldPtr world = channel.world();
  const auto sight = pointWorld(*world)->makeQuery();
  const auto object = world->makeQuery();
  const Se3Metric metric(world->objectRadius());
  const auto isFree = [&](const Pose& from, const Pose& to) {
    return object->checkMotion(from, to, 1e-6, SeekViolation::Any, {}).status == CertificateStatus::Certified;
  };
  RandomStream stream(1, "hands in the channel");
  int nearer = 0;
  for (int i = 0; i < 500; ++i) {
    Pose q = Pose::translation({stream.uniform(0.0, 2.0), stream.uniform(-0.04, 0.04), 0.0});
    q.orientation = fromRotationVector({0.0, 0.0, stream.uniform(-0.3, 0.3)});
    if (object->collides(q)) continue;
    const auto inSight = aheadInSight(channel.way, q, metric, 1.0, *sight);
    const auto target = reachableAhead(channel.way, q, metric, 1.0, *sight, *object);
    ASSERT_EQ(inSight.has_value(), target.has_value());
    if (!target || *target == *inSight) continue;
    EXPECT_TRUE(isFree(q, *target));
    nearer += isFree(q, *inSight) ? 0 : 1;
  }
  EXPECT_GT(nearer, 50);
}

/// A hand that goes to its targets with a tremor.
TEST(HandGuide, ATargetStaysUntilItIsReached) {
  const Channel channel;
  const CollisionWorldPtr world = channel.world();
  const auto sight = pointWorld(*world)->makeQuery();
  const auto object = world->makeQuery();
  constexpr double kAhead = 0.5;
  HandGuide guide(channel.way, Se3Metric(world->objectRadius()), kAhead);
  RandomStream tremor(1, "tremor");
  Pose q = channel.way.front();
  std::optional<Pose> before;
  int others = 0;
  int steps = 0;
  for (; steps < 1000 && (q.position - channel.way.back().position).norm() > 0.05; ++steps) {
    const auto target = guide.lead(q, *sight, *object);
    ASSERT_TRUE(target);
    others += before && *target != *before ? 1 : 0;
    before = target;
    const Vector3 way = target->position - q.position;
    Pose next = q;
    next.position += way.normalized() * std::min(0.02, way.norm());
    next.position += 0.002 * Vector3(tremor.uniform(-1.0, 1.0), tremor.uniform(-1.0, 1.0), 0.0);
    if (!object->collides(next)) q = next;
  }
  EXPECT_LT(steps, 1000) << "the hand gets there";
  EXPECT_LT(others, steps / 5);
}

}  // namespace
}  // namespace glissade
