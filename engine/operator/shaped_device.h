#pragma once

#include "engine/operator/hand_inputs.h"
#include "engine/operator/operator_input.h"

namespace glissade {

/// The shaped deflection of a hand-held device over time. Keys ramp up to full deflection smoothly, so that a tap is a
/// small precise step; a release acts at once. Used by one thread.
class HandShaper {
 public:
  explicit HandShaper(const HandInput& input) : input_(input) {}

  /// The deflection after dt more seconds, with this shaping; at rest where `maySteer` is false.
  Deflection deflection(double dt, const DeviceShaping& shaping, bool maySteer);
  void restart();

 private:
  const HandInput& input_;
  RawAxes ramped_{};
  DominantAxis dominant_;
};

/// A hand-held device as an operator: its latest axes, shaped, move the object, integrated in our own clock. At rest
/// while the camera is steered or the window has no focus.
class ShapedDevice final : public OperatorDevice {
 public:
  /// `input` belongs to `hand`.
  ShapedDevice(HandInputsPtr hand, const HandInput& input);

  Pose advance(double dt, const OperatorView& view, const Box3& bounds) override;
  void restart() override { shaper_.restart(); }
  bool connected() const override { return input_.mailbox.reading().connected; }

 private:
  HandInputsPtr hand_;
  const HandInput& input_;
  HandShaper shaper_;
};

}  // namespace glissade
