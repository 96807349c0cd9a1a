#include "widgets/openxr/room_walk.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

/// Distance of the hands below which they neither turn nor scale, metres of the room.
constexpr double kLeastBetween = 0.05;

/// Angle about the vertical axis of the world.
double azimuth(const Vector3& v_W) { return std::atan2(v_W.y(), v_W.x()); }

/// The point on the floor of the room at which the hand points; nothing if it is too far away.
std::optional<Vector3> pointOnFloor(const Pose& X_RA) {
  const Vector3 direction = X_RA.orientation * -Vector3::UnitZ();
  if (direction.y() >= 0.0) return std::nullopt;
  const double distance = -X_RA.position.y() / direction.y();
  if (distance < 0.0 || distance > RoomWalk::kFarthest) return std::nullopt;
  const Vector3 p = X_RA.position + distance * direction;
  return Vector3(p.x(), 0.0, p.z());
}

}  // namespace

void RoomWalk::place(const RoomPlacement& room) {
  room_ = room;
  pull_.reset();
  target_R_.reset();
}

void RoomWalk::advance(const WalkInput& input) {
  pull(input);
  step(input);
}

std::optional<Vector3> RoomWalk::target() const {
  if (!target_R_) return std::nullopt;
  return inWorld(room_, Pose::translation(*target_R_)).position;
}

bool RoomWalk::closes(const ControllerState& state, ControllerSide side) {
  bool& closed = closed_[static_cast<std::size_t>(side)];
  closed = state.X_RG && state.squeeze >= (closed ? kOpened : kClosed);
  return closed;
}

void RoomWalk::pull(const WalkInput& input) {
  const auto& [left, right] = input.controllers;
  const bool isLeft = closes(left, ControllerSide::Left);
  const bool isRight = closes(right, ControllerSide::Right);
  const bool mainIsLeft = input.mainHand == ControllerSide::Left;
  const bool otherPulls = mainIsLeft ? isRight && !input.holds[1] : isLeft && !input.holds[0];
  const bool both = isLeft && isRight && !input.holds[0] && !input.holds[1];
  if (!otherPulls) {
    pull_.reset();
    return;
  }
  const Vector3 p_R =
      both ? Vector3(0.5 * (left.X_RG->position + right.X_RG->position)) : (mainIsLeft ? right : left).X_RG->position;
  const auto worldOf = [this](const Vector3& p) { return inWorld(room_, Pose::translation(p)).position; };
  if (!pull_ || pull_->between_W.has_value() != both) {
    pull_ = Pull{worldOf(p_R)};
    if (both) pull_->between_W = worldOf(right.X_RG->position) - worldOf(left.X_RG->position);
    return;
  }
  if (both) {
    const Vector3 between_R = right.X_RG->position - left.X_RG->position;
    const double length_W = pull_->between_W->norm();
    if (between_R.norm() > kLeastBetween && length_W * room_.scale > 0.0) {
      room_.scale = std::clamp(between_R.norm() / length_W, kLeastScale, kLargestScale);
      turn(azimuth(*pull_->between_W) - azimuth(room_.X_WR.orientation * between_R), p_R);
    }
  }
  keep(pull_->p_W, p_R);
}

/// Moves the room so that its point p_R is at p_W.
void RoomWalk::keep(const Vector3& p_W, const Vector3& p_R) {
  room_.X_WR.position += p_W - inWorld(room_, Pose::translation(p_R)).position;
}

/// Turns the room about the vertical axis through its point p_R.
void RoomWalk::turn(double angle, const Vector3& p_R) {
  const Vector3 p_W = inWorld(room_, Pose::translation(p_R)).position;
  const Quaternion turned(Eigen::AngleAxisd(angle, Vector3::UnitZ()));
  room_.X_WR.orientation = (turned * room_.X_WR.orientation).normalized();
  keep(p_W, p_R);
}

void RoomWalk::step(const WalkInput& input) {
  std::optional<Vector3> pointed;
  bool isPushed = false;
  for (std::size_t i = 0; i < input.controllers.size(); ++i) {
    const ControllerState& state = input.controllers[i];
    const double forward = state.stick.y();
    if (forward >= (target_R_ ? kReleased : kPushed)) {
      isPushed = true;
      if (state.X_RA) pointed = pointOnFloor(*state.X_RA);
    }
    const double side = state.stick.x();
    const bool isAside = std::abs(side) >= (aside_[i] ? kReleased : kPushed) && std::abs(side) > std::abs(forward);
    if (isAside && !aside_[i]) turn(side > 0.0 ? -kTurn : kTurn, input.p_RH);
    aside_[i] = isAside;
  }
  if (isPushed) {
    target_R_ = pointed;
  } else if (target_R_) {
    keep(inWorld(room_, Pose::translation(*target_R_)).position, Vector3(input.p_RH.x(), 0.0, input.p_RH.z()));
    target_R_.reset();
  }
}

}  // namespace glissade
