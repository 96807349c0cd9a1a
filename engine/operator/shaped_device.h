#pragma once

#include "engine/operator/hand_inputs.h"
#include "engine/operator/operator_input.h"

namespace glissade {

/// A device in a person's hand as an operator: its latest axes, shaped, move the object, integrated in
/// our own clock. At rest while the camera is steered or the window has no focus.
class ShapedDevice final : public OperatorDevice {
 public:
  /// `input` is one of `hand`'s. Keys ramp up to full deflection smoothly, so that a tap is a small
  /// precise step; release is at once.
  ShapedDevice(HandInputsPtr hand, const HandInput& input);

  Pose advance(double dt, const OperatorView& view, const Box3& bounds) override;
  void restart() override { ramped_ = RawAxes{}; }
  bool connected() const override { return input_.mailbox.reading().connected; }

 private:
  HandInputsPtr hand_;
  const HandInput& input_;
  RawAxes ramped_{};
  DominantAxis dominant_;
};

}  // namespace glissade
