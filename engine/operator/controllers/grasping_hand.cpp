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
  if (!hand_->controllersMoveObject) {
    taken_ = false;
    closed_ = true;  // a hand that is already closed takes nothing
    X_GB_.reset();
    return view.q_device;
  }
  const ControllerReading now = hand_->controller(with).place.reading();
  pointsAt_ = aimedDistance(now, view.q_device);
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

/// Closes the hand. A hand that is closed elsewhere takes nothing until it is opened. A lost controller may return with
/// its hand still closed.
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
  return pointsAt_.has_value();
}

std::optional<double> GraspingHand::aimedDistance(const ControllerReading& now, const Pose& X_WB) {
  if (!now.X_WA) return std::nullopt;
  const Pose X_BA = inverse(X_WB) * *now.X_WA;
  const double distance = surface().firstHit(X_BA.position, X_BA.orientation * -Vector3::UnitZ(), 0.0);
  return std::isfinite(distance) ? std::optional(distance) : std::nullopt;
}

const TriangleTree& GraspingHand::surface() {
  if (!surface_) surface_ = std::make_unique<const TriangleTree>(world_->object());
  return *surface_;
}

void GraspingHand::feel(const std::optional<Wrench>& pushedBack) {
  if (!hand_->controllersMoveObject) return;
  const double push = pushedBack && holds() ? std::max(pushedBack->force_W.norm(), pushedBack->torque_W.norm()) : 0.0;
  hand_->controller(side()).place.setFeedback({holds(), push, pointsAt_});
}

}  // namespace glissade
