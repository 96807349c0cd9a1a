#pragma once

#include <functional>

#include "engine/operator/device_registry.h"
#include "engine/operator/haptic/haptic_loop.h"

namespace glissade {

/// A haptic device as an operator, in real time: q_device follows the object that the loop keeps out of
/// the obstacles. advance() throws what has ended the loop.
class HapticOperator final : public OperatorDevice {
 public:
  HapticOperator(CollisionWorldPtr world, std::unique_ptr<HapticDevice> device);

  Pose advance(double dt, const OperatorView& view, const Box3& bounds) override;
  void restart() override { ++orders_.restarts; }
  bool connected() const override { return !loop_ || loop_->report().connected; }
  std::optional<Wrench> rendered() const override { return wrench_; }

 private:
  CollisionWorldPtr world_;
  std::unique_ptr<HapticDevice> device_;  ///< until the loop has it
  std::unique_ptr<HapticLoop> loop_;
  HapticOrders orders_;
  Pose q_;  ///< given back last
  Wrench wrench_;
};

/// The same in somebody else's time, cycle by cycle on the caller's thread, each with its collision query:
/// lockstep sessions. The same calls give the same motion.
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
  double owed_ = 0.0;  ///< s that are not a whole cycle yet
};

/// A haptic device for the registry of devices; without a world to feel nothing is made.
DeviceEntry hapticEntry(std::string id, std::string label, std::string description, bool simulated,
                        std::function<std::unique_ptr<HapticDevice>(const DeviceContext&)> make);

}  // namespace glissade
