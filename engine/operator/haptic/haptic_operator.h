#pragma once

#include <functional>

#include "engine/base/message.h"
#include "engine/operator/device_registry.h"
#include "engine/operator/haptic/haptic_loop.h"

namespace glissade {

/// A haptic device as an operator, in real time. q_device follows the object that the loop keeps out of the obstacles.
/// advance() throws the exception that has ended the loop.
class HapticOperator final : public OperatorDevice {
 public:
  HapticOperator(CollisionWorldPtr world, std::unique_ptr<HapticDevice> device);

  Pose advance(double dt, const OperatorView& view, const Box3& bounds) override;
  void restart() override { ++orders_.restarts; }
  bool connected() const override { return !loop_ || loop_->report().connected; }
  std::optional<Wrench> rendered() const override { return wrench_; }

 private:
  CollisionWorldPtr world_;
  std::unique_ptr<HapticDevice> device_;  ///< device until the loop owns it
  std::unique_ptr<HapticLoop> loop_;
  HapticOrders orders_;
  Pose q_;  ///< last returned pose
  Wrench wrench_;
};

/// A haptic device as an operator in the caller's time: it runs cycle by cycle on the caller's thread, each with its
/// collision query, for lockstep sessions. The same calls give the same motion.
class SteppedHapticOperator final : public OperatorDevice {
 public:
  SteppedHapticOperator(const CollisionWorldPtr& world, std::unique_ptr<HapticDevice> device);

  Pose advance(double dt, const OperatorView& view, const Box3& bounds) override;
  void restart() override { servo_.restart(); }
  bool connected() const override { return servo_.connected(); }
  std::optional<Wrench> rendered() const override { return cycle_.wrench; }

 private:
  std::unique_ptr<CollisionQuery> query_;
  double objectRadius_;
  HapticServo servo_;
  HapticCycle cycle_;
  bool placed_ = false;
  double owed_ = 0.0;  ///< seconds that are not a whole cycle yet
};

/// An entry of the registry for a haptic device. It makes no device without a world.
DeviceEntry hapticEntry(std::string id, CatalogueText label, CatalogueText description, bool simulated,
                        std::function<std::unique_ptr<HapticDevice>(const DeviceContext&)> make);

}  // namespace glissade
