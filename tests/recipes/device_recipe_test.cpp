// Carries out the recipe "Add a device": a device with a motion of its own, six axes, and a device that pushes back.
#include <gtest/gtest.h>

#include "engine/operator/haptic/haptic_operator.h"
#include "engine/operator/shaped_device.h"
#include "tests/engine/operator/device_conformance.h"
#include "tests/engine/operator/haptic/haptic_device_conformance.h"
#include "tests/engine/operator/operator_support.h"

namespace glissade {
namespace {

/// A simulated person who lifts the object.
class Lift final : public OperatorDevice {
 public:
  Pose advance(double dt, const OperatorView& view, const Box3& bounds) override {
    return integrate(view.q_device, {{0.0, 0.0, kSpeed}, Vector3::Zero()}, bounds, dt);
  }
  bool isSimulated() const override { return true; }

  static constexpr double kSpeed = 0.1;  ///< m/s
};

/// A hand without mass: it moves by the rendered force.
class SoftHand final : public HapticDevice {
 public:
  HapticState advance(double dt) override {
    constexpr double kSpeed = 0.5;  // m/s at full force
    state_.V_WD.linear_W = kSpeed / limits().force * wrench_.force_W;
    state_.X_WD.position += dt * state_.V_WD.linear_W;
    return state_;
  }
  void render(const Wrench& wrench) override { wrench_ = wrench; }
  HapticLimits limits() const override { return {3.0, 0.2}; }
  void place(const Pose& X_WD) override { state_.X_WD = X_WD; }

 private:
  HapticState state_;
  Wrench wrench_;
};

DeviceRegistry devicesWithRecipes() {
  DeviceRegistry registry = makeDeviceRegistry();
  registry.add({"lift", GLISSADE_TEXT("Lift"), GLISSADE_TEXT("Lifts the object."), true,
                [](const DeviceContext&) { return std::make_unique<Lift>(); }});
  registry.add({"puck", GLISSADE_TEXT("Puck"), GLISSADE_TEXT("A person: six axes."), false,
                [](const DeviceContext& context) -> std::unique_ptr<OperatorDevice> {
                  if (!context.hand) return nullptr;
                  return std::make_unique<ShapedDevice>(context.hand, context.hand->gamepad);
                }});
  registry.add(hapticEntry("soft-hand", GLISSADE_TEXT("Soft hand"), GLISSADE_TEXT("Gives way."), true,
                           [](const DeviceContext&) { return std::make_unique<SoftHand>(); }));
  return registry;
}

TEST(DeviceRecipe, TheNewDeviceMovesTheObjectInTheGivenTime) {
  const auto lift = devicesWithRecipes().find("lift")->make({});
  const Pose q = lift->advance(2.0, viewOf(Pose::identity()), kRoom);
  EXPECT_EQ(q, Pose::translation({0.0, 0.0, 2.0 * Lift::kSpeed}));
}

TEST(DeviceRecipe, AReaderOfSixAxesOnlyWritesToTheMailbox) {
  DeviceContext context;
  context.hand = std::make_shared<HandInputs>();
  const auto puck = devicesWithRecipes().find("puck")->make(context);
  InputMailbox& mailbox = context.hand->gamepad.mailbox;
  mailbox.connect("Puck");
  mailbox.setAxes({1.0, 0.0, 0.0, 0.0, 0.0, 0.0});
  const Pose moved = puck->advance(0.1, viewOf(Pose::identity()), kRoom);
  EXPECT_GT(moved.position.norm(), 0.0);
  mailbox.setAxes({});
  EXPECT_EQ(puck->advance(0.1, viewOf(moved), kRoom), moved);
}

}  // namespace

DevicesUnderTest devicesUnderTest() { return {devicesWithRecipes(), {"lift", "puck", "soft-hand"}}; }

std::vector<HapticDeviceUnderTest> hapticDevicesUnderTest() {
  return {{"SoftHand", [] { return std::make_unique<SoftHand>(); }}};
}

}  // namespace glissade
