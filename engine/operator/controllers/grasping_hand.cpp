#include "engine/operator/controllers/grasping_hand.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace glissade {

GraspingHand::GraspingHand(HandInputsPtr hand, std::optional<ControllerSide> side, CollisionWorldPtr world)
    : hand_(std::move(hand)), side_(side), world_(std::move(world)), last_(this->side()) {}

bool GraspingHand::connected() const { return hand_->controller(side()).buttons.mailbox.reading().connected; }

Pose GraspingHand::advance(double dt, const OperatorView& view, const Box3& bounds) {
  if (dt <= 0.0) return view.q_device;
  const ControllerSide with = side();
  if (std::exchange(last_, with) != with) {
    closed_ = taken_ = false;
    X_GB_.reset();
  }
  const ControllerReading now = hand_->controller(with).place.reading();
  close(now, view.q_device);
  if (!taken_ || !now.X_WG) {
    X_GB_.reset();
    return view.q_device;
  }
  if (!X_GB_) {
    X_GB_ = inverse(*now.X_WG) * view.q_device;
    return view.q_device;
  }
  Pose led = *now.X_WG * *X_GB_;
  led.orientation.normalize();
  led.position = led.position.cwiseMax(bounds.min()).cwiseMin(bounds.max());
  return led;
}

/// A hand that is closed elsewhere takes nothing until it is opened. A controller that is lost may come back with its
/// hand still closed.
void GraspingHand::close(const ControllerReading& now, const Pose& X_WB) {
  const bool isClosed = now.squeeze >= (closed_ ? kLetsGo : kTakes);
  if (isClosed && !closed_) taken_ = now.X_WG && reaches(now, X_WB);
  if (!isClosed) taken_ = false;
  closed_ = isClosed;
}

bool GraspingHand::reaches(const ControllerReading& now, const Pose& X_WB) {
  const Pose X_BW = inverse(X_WB);
  const double reach = kReach / now.scale;
  if (surface().nearest(X_BW * now.X_WG->position, reach, reach).distance < reach) return true;
  if (!now.X_WA) return false;
  const Vector3 direction = X_BW.orientation * (now.X_WA->orientation * -Vector3::UnitZ());
  return std::isfinite(surface().firstHit(X_BW * now.X_WA->position, direction, 0.0));
}

const TriangleTree& GraspingHand::surface() {
  if (!surface_) surface_ = std::make_unique<const TriangleTree>(world_->object());
  return *surface_;
}

void GraspingHand::feel(const std::optional<Wrench>& pushedBack) {
  const double push = pushedBack && holds() ? std::max(pushedBack->force_W.norm(), pushedBack->torque_W.norm()) : 0.0;
  hand_->controller(side()).place.setFeedback({holds(), push});
}

}  // namespace glissade
