#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/random_stream.h"
#include "engine/planning/path_certificate.h"
#include "engine/sequence/motion_world.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

std::size_t bodyNamed(const AssembledProduct& product, const std::string& id) { return *product.indexOf(id); }

TEST(MotionTrial, ADrawerLeavesWhenItsPinHas) {
  const AssembledProduct product = test::lockedDrawer();
  const ProductFits fits = test::fitsOf(product);
  MotionTrial trial(product, fits, 1);
  BodySet present(4, true);
  const auto drawer = bodyNamed(product, "drawer");
  const auto pin = bodyNamed(product, "pin");
  const auto cap = bodyNamed(product, "cap");
  const RemovalAnswer locked = trial.tryRemoval(drawer, present, 0, {});
  ASSERT_TRUE(std::holds_alternative<Refused>(locked));
  const auto& blocking = std::get<Refused>(locked).blockedBy;
  EXPECT_NE(std::find(blocking.begin(), blocking.end(), pin), blocking.end());
  EXPECT_TRUE(std::holds_alternative<Refused>(trial.tryRemoval(pin, present, 0, {})));
  present[cap] = present[pin] = false;
  const RemovalAnswer open = trial.tryRemoval(drawer, present, 0, {});
  ASSERT_TRUE(std::holds_alternative<Removed>(open));
  const auto& path = std::get<Removed>(open).path;
  EXPECT_EQ(path.certificate.status, CertificateStatus::Certified);
  EXPECT_GT(path.points.back().q.position.x(), 0.7);
}

TEST(MotionTrial, AnAnswerDoesNotDependOnWhatWasAskedBefore) {
  const AssembledProduct product = test::lockedDrawer();
  const ProductFits fits = test::fitsOf(product);
  RandomStream random(3, "questions");
  MotionTrial asked(product, fits, 1);
  for (int question = 0; question < 40; ++question) {
    const auto body = static_cast<std::size_t>(random.uniform(0.0, 4.0));
    BodySet present(4);
    for (std::size_t other = 0; other < 4; ++other) present[other] = other == body || random.uniform() < 0.6;
    MotionTrial fresh(product, fits, 1);
    const RemovalAnswer one = asked.tryRemoval(body, present, 0, {});
    const RemovalAnswer other = fresh.tryRemoval(body, present, 0, {});
    ASSERT_EQ(one.index(), other.index());
    if (const auto* removed = std::get_if<Removed>(&one)) {
      EXPECT_EQ(removed->path.points.back().q, std::get<Removed>(other).path.points.back().q);
    }
  }
}

/// What was proved against bodies holds when some of them have left.
TEST(MotionTrial, MotionsHoldForEverySubset) {
  const AssembledProduct product = test::lockedDrawer();
  const ProductFits fits = test::fitsOf(product);
  PreparedBodies prepared(product.bodies);
  const AssemblyPlan plan = test::planOf(product, "cabinet");
  BodySet present(4, true);
  for (const AssemblyStep& step : plan.steps) {
    const std::size_t body = bodyNamed(product, step.body);
    present[body] = false;
    for (unsigned mask = 0; mask < 16; ++mask) {
      BodySet subset = present;
      for (std::size_t other = 0; other < 4; ++other) subset[other] = subset[other] && (mask >> other & 1U) != 0;
      const auto motion = motionWorld(product, fits, prepared, body, subset);
      const auto certificate =
          certifyPath(*motion.world->makeQuery(), step.path, motionParameters(product.bodies[body]));
      EXPECT_EQ(certificate.status, CertificateStatus::Certified) << step.body << ", bodies " << mask;
    }
  }
}

TEST(MotionTrial, ComposedWorldsAnswerAsThoseBuiltAtOnce) {
  const AssembledProduct product = test::lockedDrawer();
  const ProductFits fits = test::fitsOf(product);
  PreparedBodies prepared(product.bodies);
  RandomStream random(4, "poses");
  for (std::size_t body = 0; body < 4; ++body) {
    BodySet others(4, true);
    const auto motion = motionWorld(product, fits, prepared, body, others);
    std::vector<RigidBody> obstacles = product.bodies;
    obstacles.erase(obstacles.begin() + static_cast<std::ptrdiff_t>(body));
    const auto built = CollisionWorld::build(obstacles, product.bodies[body].mesh);
    const auto one = motion.world->makeQuery();
    const auto other = built->makeQuery();
    EXPECT_EQ(motion.world->objectRadius(), built->objectRadius());
    for (int i = 0; i < 300; ++i) {
      Pose q{Vector3(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)),
             fromRollPitchYaw(random.uniform(-3.0, 3.0), random.uniform(-1.5, 1.5), random.uniform(-3.0, 3.0))};
      EXPECT_EQ(one->collidingBody(q), other->collidingBody(q));
      EXPECT_EQ(one->nearestObstacle(q).distance, other->nearestObstacle(q).distance);
      EXPECT_EQ(one->clearAbove(q, 0.1), other->clearAbove(q, 0.1));
    }
  }
}

}  // namespace
}  // namespace glissade
