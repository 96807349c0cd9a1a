// Tests the haptic servo at contact between two parts of 100,000 triangles, measured from outside.
#include <gtest/gtest.h>

#include "engine/base/random_stream.h"
#include "engine/operator/haptic/haptic_servo.h"
#include "engine/operator/haptic/simulated_haptic_device.h"
#include "tests/engine/operator/haptic/haptic_support.h"
#include "tests/engine/operator/operator_support.h"
#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

const Pose kFree = Pose::translation({1.6, 0.0, 0.0});

class HapticContact : public testing::Test {
 protected:
  static void SetUpTestSuite() { world = denseWorld(); }
  static void TearDownTestSuite() { world.reset(); }

  HapticServo servoWith(HandMotion motion) {
    record = std::make_shared<WatchedDevice::Record>();
    auto hand = std::make_unique<SimulatedHapticDevice>(std::move(motion), world->objectRadius());
    HapticServo servo(std::make_unique<WatchedDevice>(std::move(hand), record), world->objectRadius());
    servo.place(kFree);
    return servo;
  }

  /// Runs a cycle with data that arrive every `lateness` cycles, with an age of that many cycles.
  HapticCycle cycle(HapticServo& servo, const Guidance& guidance, int lateness) {
    if (cycles_++ % lateness == 0) {
      if (pending_) servo.learn(*pending_);
      pending_ = lookAround(*query, servo.object().pose(), 0.3);
    }
    return servo.cycle(HapticServo::kPeriod, guidance, kRoom);
  }

  static CollisionWorldPtr world;
  std::unique_ptr<CollisionQuery> query = world->makeQuery();
  std::shared_ptr<WatchedDevice::Record> record;

 private:
  int cycles_ = 0;
  std::optional<Surroundings> pending_;
};

CollisionWorldPtr HapticContact::world;

TEST_F(HapticContact, GivesOutNoMoreEnergyThanWasPutIn) {
  ASSERT_GT(world->object().triangles.size(), 100000U);
  for (const int lateness : {1, 20}) {
    for (const double repulsion : {0.0, 0.8}) {
      RandomStream stream(static_cast<std::uint64_t>(lateness), "hand");
      std::vector<Pose> aims;
      for (int i = 0; i < 12; ++i) aims.push_back(randomPose(stream, 0.6));
      HapticServo servo = servoWith(
          [aims](double seconds, const Pose&) { return aims[static_cast<std::size_t>(seconds / 0.5) % aims.size()]; });
      int touching = 0;
      for (int i = 0; i < 6000; ++i) {
        const HapticCycle now = cycle(servo, {repulsion, 0.0, 0.2, std::nullopt}, lateness);
        if (servo.object().nearest().body >= 0 && servo.object().nearest().distance < 0.01) ++touching;
        ASSERT_LE(now.wrench.force_W.norm(), 1.0 + 1e-9);
      }
      const double strongestPush = SimulatedHapticDevice({}, world->objectRadius()).limits().force;
      const double stored = strongestPush * world->objectRadius() / 3.0;
      const double tolerance = 0.02 * stored;
      EXPECT_GE(record->lowest, -stored * (repulsion > 0.0 ? 1.0 : 0.0) - tolerance);
      EXPECT_LE(record->strongest, 1.0 + 1e-9);
      EXPECT_TRUE(touching > 300 || repulsion > 0.0) << "the motions did not touch: " << lateness << " " << repulsion;
      EXPECT_FALSE(query->collides(servo.object().pose()));
    }
  }
}

TEST_F(HapticContact, PressedAgainstThePartItComesToRest) {
  for (const int lateness : {1, 20}) {
    HapticServo servo = servoWith([](double, const Pose&) { return Pose::translation({0.4, 0.0, 0.0}); });
    Box3 early;
    Box3 settled;
    for (int i = 0; i < 6000; ++i) {
      cycle(servo, {0.5, 0.0, 0.2, std::nullopt}, lateness);
      if (i >= 1000 && i < 2000) early.extend(record->X_WD.position);
      if (i >= 5000) settled.extend(record->X_WD.position);
    }
    EXPECT_LT(settled.diagonal().norm(), (lateness == 1 ? 0.001 : 0.03) * world->objectRadius());
    EXPECT_LE(settled.diagonal().norm(), early.diagonal().norm() + 1e-3);
    EXPECT_GT(record->strongest, 0.1) << "it was not pressed";
  }
}

TEST_F(HapticContact, AttractionDrawsTheHandToTheTarget) {
  HapticServo servo = servoWith([](double, const Pose& begin) { return begin; });
  const Pose target = Pose::translation({1.6, 0.3, 0.0});
  for (int i = 0; i < 2000; ++i) cycle(servo, {0.5, 1.0, 0.2, target}, 1);
  EXPECT_GT(servo.object().pose().position.y(), 0.02);
}

TEST(PassivityController, DampsWhatGaveOutEnergy) {
  PassivityController controller(1.0, {1.0, 1.0}, 0.0);
  const Wrench push{{0.5, 0.0, 0.0}, Vector3::Zero()};
  Twist twist;
  twist.linear_W = {0.1, 0.0, 0.0};
  EXPECT_EQ(controller.damped(push, twist, 1e-3).force_W, push.force_W);
  controller.observe(Pose(), Pose::translation({0.1, 0.0, 0.0}), push);
  EXPECT_LT(controller.balance(), 0.0);
  EXPECT_LT(controller.damped(push, twist, 1e-3).force_W.x(), 0.0);
  controller.observe(Pose::translation({0.1, 0.0, 0.0}), Pose(), push);
  EXPECT_NEAR(controller.balance(), 0.0, 1e-15);
}

}  // namespace
}  // namespace glissade
