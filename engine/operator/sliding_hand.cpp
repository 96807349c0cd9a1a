#include "engine/operator/sliding_hand.h"

#include <algorithm>
#include <limits>

#include "engine/collision/contact_planes.h"

namespace glissade {
namespace {

/// Time in which one distance query is made, seconds. Each proves a ball in which the object moves.
constexpr double kQueryPeriod = 1e-3;
/// Least lead of the hand that gives a force, in radii of the object.
constexpr double kNoLead = 1e-3;

/// The configuration on the straight motion at which no point has moved by more than `most` metres.
Pose within(const Pose& from, const Pose& to, double most, double radius) {
  const double length = longestWay(from, to, radius);
  return length <= most ? to : interpolate(from, to, most / length);
}

}  // namespace

SlidingHand::SlidingHand(CollisionWorldPtr world, std::unique_ptr<OperatorDevice> device)
    : world_(std::move(world)),
      device_(std::move(device)),
      object_(world_->objectRadius()),
      radius_(world_->objectRadius()),
      clearance_(std::numeric_limits<double>::infinity()) {}

void SlidingHand::restart() {
  device_->restart();
  placed_ = false;
}

void SlidingHand::place(const Pose& q) {
  q_ = hand_ = q;
  object_.place(q);
  clearance_ = std::numeric_limits<double>::infinity();
  placed_ = true;
}

Pose SlidingHand::advance(double dt, const OperatorView& view, const Box3& bounds) {
  if (dt <= 0.0) return view.q_device;
  if (!placed_ || view.q_device != q_) {
    place(view.q_device);
    device_->regrip();
  }
  const Pose q = moved(dt, view, bounds);
  device_->feel(rendered());
  return q;
}

Pose SlidingHand::moved(double dt, const OperatorView& view, const Box3& bounds) {
  const Pose led = ledBy(dt, view, bounds);
  if (led == hand_ && !device_->holds()) {
    hand_ = q_;
    return q_;
  }
  hand_ = within(q_, led, kMostLead * radius_, radius_);
  if (!query_ && world_->isPrepared()) query_ = world_->makeQuery();
  if (query_) {
    follow(dt);
  } else {
    place(hand_);
  }
  return q_;
}

/// Pose to which the device moves the hand, slower near obstacles.
Pose SlidingHand::ledBy(double dt, const OperatorView& view, const Box3& bounds) {
  OperatorView ofHand = view;
  ofHand.q_device = hand_;
  const double share = std::clamp(clearance_ / (kSlowFrom * radius_), kSlowest, 1.0);
  ofHand.frame.speed.linear *= share;
  ofHand.frame.speed.angular *= share;
  return device_->advance(dt, ofHand, bounds);
}

void SlidingHand::follow(double dt) {
  const int most = std::max(1, static_cast<int>(dt / kQueryPeriod));
  for (int query = 0; query < most && object_.pose() != hand_; ++query) {
    if (object_.needsSurroundings()) {
      const Surroundings around = lookAround(*query_, object_.pose(), kSlowFrom * radius_);
      clearance_ = around.clearance;
      object_.learn(around);
    }
    const Pose before = object_.pose();
    if (object_.follow(hand_) == before) break;
  }
  q_ = object_.pose();
}

/// The force of obstacles that hold the object back.
std::optional<Wrench> SlidingHand::rendered() const {
  if (!hand()) return std::nullopt;
  Wrench wrench;
  wrench.force_W = (q_.position - hand_.position) / (kMostLead * radius_);
  wrench.torque_W = rotationVector(hand_.orientation, q_.orientation) / kMostLead;
  return wrench;
}

std::optional<Pose> SlidingHand::hand() const {
  if (!placed_ || longestWay(q_, hand_, radius_) < kNoLead * radius_) return std::nullopt;
  return hand_;
}

}  // namespace glissade
