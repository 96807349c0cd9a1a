#pragma once

#include <functional>
#include <vector>

#include "engine/geometry/se3_metric.h"
#include "engine/operator/haptic/haptic_device.h"

namespace glissade {

/// The intended pose of a scripted hand, `seconds` after it began at `begin`.
using HandMotion = std::function<Pose(double seconds, const Pose& begin)>;

/// A motion from `begin` through the way points at a steady speed (metres of the metric per second), then at rest.
HandMotion alongRoute(std::vector<Pose> route, const Se3Metric& metric, double speed);

/// A haptic device with a simulated hand, so that loops run without hardware: mass and damper, pulled by the spring of
/// the arm to the intended pose of the hand, pushed by the rendered wrench. The hand moves the object over its radius
/// with 5 cm of its own travel. The source states the values at the hand. Deterministic.
class SimulatedHapticDevice final : public HapticDevice {
 public:
  SimulatedHapticDevice(HandMotion motion, double objectRadius);

  HapticState advance(double dt) override;
  void render(const Wrench& wrench) override { wrench_ = wrench; }
  HapticLimits limits() const override;
  void place(const Pose& X_WD) override;
  void restart() override;

 private:
  HandMotion motion_;
  double worldPerHand_;
  double seconds_ = 0.0;
  Pose begin_;
  HapticState state_;
  Wrench wrench_;
};

}  // namespace glissade
