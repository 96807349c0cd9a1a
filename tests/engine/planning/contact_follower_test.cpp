#include "engine/planning/contact/contact_follower.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "engine/planning/contact/contact_sampler.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

constexpr double kGap = 1e-3;

OperatorSample handAt(const CollisionWorld& world, const Pose& q) {
  OperatorSample hand;
  hand.q_device = q;
  hand.nearest = world.makeQuery()->nearestObstacle(q);
  return hand;
}

/// A floor below z = 0 and a wall below x = 0, with a cube of 0.4 m between them.
CollisionWorldPtr corner() {
  return CollisionWorld::build({boxBody("floor", {6.0, 6.0, 1.0}, Pose::translation({0.0, 0.0, -0.5})),
                                boxBody("wall", {1.0, 6.0, 6.0}, Pose::translation({-0.5, 0.0, 0.0}))},
                               std::make_shared<const TriangleMesh>(makeBox({0.4, 0.4, 0.4})));
}

/// Angle between the cube's nearest face and the horizontal plane, radians.
double tilt(const Pose& q) {
  double best = 0.0;
  for (int axis = 0; axis < 3; ++axis) best = std::max(best, std::abs((q.orientation * Vector3::Unit(axis)).z()));
  return std::acos(std::min(1.0, best));
}

/// The next end of a leg; every other sample is the paper's.
Pose nextLeg(ContactFollower& follower, CollisionQuery& query) {
  const Pose leg = follower.sample(query);
  (void)follower.sample(query);
  return leg;
}

TEST(ContactFollower, NoLegEndsInAnythingByFcl) {
  RandomStream stream(11, "clutter");
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<RigidBody> bodies;
    for (int i = 0; i < 8; ++i) {
      const Vector3 size = Vector3::Constant(0.3) + 0.7 * Vector3(stream.uniform(), stream.uniform(), stream.uniform());
      bodies.push_back(boxBody("box" + std::to_string(i), size, randomPose(stream, 1.5)));
    }
    const auto world = CollisionWorld::build(bodies, makeL());
    const auto oracle = world->withBackend(CollisionBackend::Fcl)->makeQuery();
    const auto query = world->makeQuery();
    OperatorSample hand = handAt(*world, randomPose(stream, 3.0));
    while (hand.nearest.distance <= 0.0) hand = handAt(*world, randomPose(stream, 3.0));
    ContactFollower follower(world->objectRadius(), static_cast<std::uint64_t>(trial));
    follower.enter(hand, kGap, 0.5);
    for (int i = 0; i < 30; ++i) EXPECT_GE(oracle->nearestObstacle(nextLeg(follower, *query)).distance, 0.4 * kGap);
  }
}

TEST(ContactFollower, AFaceComesToLieFlatOnThePlaneItMeets) {
  const auto world = corner();
  const auto query = world->makeQuery();
  Pose q = Pose::translation({1.5, 0.0, 0.5});
  q.orientation = fromRollPitchYaw(0.3, 0.25, 0.1);
  ContactFollower follower(world->objectRadius(), 3);
  follower.enter(handAt(*world, q), kGap, 0.3);
  ASSERT_GT(tilt(q), 0.3);
  double least = tilt(q);
  for (int i = 0; i < 60; ++i) least = std::min(least, tilt(nextLeg(follower, *query)));
  EXPECT_LT(least, 0.02);
}

TEST(ContactFollower, TwoPlanesGuideTheObjectAlongTheirLine) {
  const auto world = corner();
  const auto query = world->makeQuery();
  ContactFollower follower(world->objectRadius(), 5);
  follower.enter(handAt(*world, Pose::translation({0.4, 0.0, 0.25})), kGap, 0.5);
  double least = 6.0;
  double most = -6.0;
  for (int i = 0; i < 300; ++i) {
    const Pose q = nextLeg(follower, *query);
    const bool inCorner = q.position.x() < 0.21 && q.position.z() < 0.21;
    if (!inCorner) continue;
    least = std::min(least, q.position.y());
    most = std::max(most, q.position.y());
  }
  EXPECT_GT(most - least, 0.2) << "metres along the line of floor and wall";
}

/// Number of planes of a pit with five faces that the samples of one contact mode touch.
template <typename Sample>
std::size_t planesTouched(const CollisionWorld& world, const Sample& sample) {
  const auto query = world.makeQuery();
  std::set<int> touched;
  for (int i = 0; i < 60; ++i) {
    const NearestObstacle nearest = query->nearestObstacle(sample());
    if (nearest.distance > 0.0 && nearest.distance < 2.0 * kGap) touched.insert(nearest.body);
  }
  return touched.size();
}

TEST(ContactFollower, ItGoesFromOnePlaneToTheNextAndThePapersSamplingDoesNot) {
  const auto world = CollisionWorld::build({boxBody("floor", {4.0, 4.0, 1.0}, Pose::translation({0.0, 0.0, -0.5})),
                                            boxBody("left", {1.0, 4.0, 2.0}, Pose::translation({-1.0, 0.0, 1.0})),
                                            boxBody("right", {1.0, 4.0, 2.0}, Pose::translation({1.0, 0.0, 1.0})),
                                            boxBody("front", {1.0, 1.0, 2.0}, Pose::translation({0.0, -1.0, 1.0}))},
                                           std::make_shared<const TriangleMesh>(makeBox({0.4, 0.4, 0.4})));
  const OperatorSample hand = handAt(*world, Pose::translation({0.0, 0.0, 0.25}));
  const auto query = world->makeQuery();
  ContactFollower follower(world->objectRadius(), 7);
  follower.enter(hand, kGap, 1.0);
  EXPECT_GE(planesTouched(*world, [&] { return nextLeg(follower, *query); }), 3U);
  ContactSampler sampler(7);
  sampler.enter(hand, kGap, 1.0);
  EXPECT_EQ(planesTouched(*world, [&] { return sampler.sample(); }), 1U);
}

TEST(ContactFollower, TheFirstLegGoesTheWayOfTheHand) {
  const auto world = corner();
  const auto query = world->makeQuery();
  for (const double direction : {-1.0, 1.0}) {
    ContactFollower follower(world->objectRadius(), 9);
    follower.enter(handAt(*world, Pose::translation({2.0, 0.0, 0.23})), kGap, 0.5);
    follower.enter(handAt(*world, Pose::translation({2.0, 0.1 * direction, 0.23})), kGap, 0.5);
    EXPECT_GT(direction * (nextLeg(follower, *query).position.y() - 0.1 * direction), 0.05);
  }
}

TEST(ContactFollower, EveryOtherSampleIsOnThePlaneOfTheHandAndKeepsItsOrientation) {
  const auto world = corner();
  const auto query = world->makeQuery();
  Pose q = Pose::translation({1.5, 0.0, 0.5});
  q.orientation = fromRollPitchYaw(0.3, 0.25, 0.1);
  const OperatorSample hand = handAt(*world, q);
  ContactFollower follower(world->objectRadius(), 3);
  follower.enter(hand, kGap, 0.3);
  const Vector3 n = hand.nearest.normal_W();
  for (int i = 0; i < 20; ++i) {
    (void)follower.sample(*query);
    const Pose sample = follower.sample(*query);
    EXPECT_EQ(sample.orientation.coeffs(), q.orientation.coeffs());
    EXPECT_NEAR(n.dot(sample.position - q.position), kGap - hand.nearest.distance, 1e-12);
  }
}

TEST(ContactFollower, TheSameSeedGivesTheSameSamples) {
  const auto world = corner();
  const OperatorSample hand = handAt(*world, Pose::translation({0.4, 0.0, 0.25}));
  ContactFollower one(world->objectRadius(), 4);
  ContactFollower other(world->objectRadius(), 4);
  one.enter(hand, kGap, 0.5);
  other.enter(hand, kGap, 0.5);
  const auto query = world->makeQuery();
  for (int i = 0; i < 50; ++i) EXPECT_EQ(one.sample(*query), other.sample(*query));
}

}  // namespace
}  // namespace glissade
