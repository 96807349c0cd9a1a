#pragma once

#include <memory>
#include <optional>

#include "engine/geometry/triangle_tree.h"
#include "engine/operator/hand_inputs.h"
#include "engine/operator/operator_input.h"

namespace glissade {

/// The object in the hand of a person with a tracked controller. A squeeze takes the object where it is: in the hand,
/// or at a distance where the controller points at it. The object then moves with the controller as one body, from the
/// place where it was taken. Letting go leaves it where it is.
///
/// A loss of tracking releases the object. When tracking returns and the hand is still closed, the object is taken
/// again where it is, so that it does not jump. The same happens where something else has moved it.
class GraspingHand final : public OperatorDevice {
 public:
  /// Squeeze of the grip above which the object is taken, and below which it is released.
  static constexpr double kTakes = 0.3;
  static constexpr double kLetsGo = 0.15;
  /// Largest distance from the middle of the hand to the surface of the object for taking it, in metres of the room.
  static constexpr double kReach = 0.08;

  /// `world` has the object. Without a side the device uses the main hand, which a person may change.
  GraspingHand(HandInputsPtr hand, std::optional<ControllerSide> side, CollisionWorldPtr world);

  Pose advance(double dt, const OperatorView& view, const Box3& bounds) override;
  void restart() override { X_GB_.reset(); }
  void regrip() override { X_GB_.reset(); }
  bool connected() const override;
  bool holds() const override { return X_GB_.has_value(); }
  void feel(const std::optional<Wrench>& pushedBack) override;

 private:
  ControllerSide side() const { return side_.value_or(hand_->mainHand); }
  void close(const ControllerReading& now, const Pose& X_WB);
  bool reaches(const ControllerReading& now, const Pose& X_WB);
  std::optional<double> aimedDistance(const ControllerReading& now, const Pose& X_WB);
  const TriangleTree& surface();

  HandInputsPtr hand_;
  std::optional<ControllerSide> side_;
  CollisionWorldPtr world_;
  std::unique_ptr<const TriangleTree> surface_;  ///< surface of the object; null until it is needed
  ControllerSide last_;
  bool closed_ = false;             ///< the hand is closed
  std::optional<double> pointsAt_;  ///< distance along the aim to the object, metres
  bool taken_ = false;              ///< the object was taken when the hand was closed
  std::optional<Pose> X_GB_;        ///< pose of the object in the hand, while it is held
};

}  // namespace glissade
