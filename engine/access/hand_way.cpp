#include "engine/access/hand_way.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glissade {
namespace {

constexpr double kSpacing = 0.01;   ///< metres
constexpr double kHandReach = 0.3;  ///< metres, from what is gripped to the middle of the forearm
constexpr double kMostSamples = 400.0;

double wayBetween(const Pose& from, const Pose& to, const Vector3& middle_W) {
  return (to * middle_W - from * middle_W).norm() + kHandReach * angleBetween(from.orientation, to.orientation);
}

}  // namespace

HandFollow HandFollow::point(const Vector3& p_W) {
  HandFollow follow;
  follow.kind_ = Kind::Point;
  follow.p_W_ = p_W;
  return follow;
}

HandFollow HandFollow::still() {
  HandFollow follow;
  follow.kind_ = Kind::Still;
  return follow;
}

Pose HandFollow::movedWith(const Pose& moved) const {
  switch (kind_) {
    case Kind::Rigidly: return moved;
    case Kind::Point: return Pose::translation(moved * p_W_ - p_W_);
    case Kind::Still: break;
  }
  return Pose::identity();
}

HandFollow followOf(const std::vector<Pose>& moved, const Vector3& middle_W) {
  double turned = 0.0;
  for (std::size_t i = 1; i < moved.size(); ++i) {
    turned += angleBetween(moved[i - 1].orientation, moved[i].orientation);
  }
  return turned > std::numbers::pi ? HandFollow::point(middle_W) : HandFollow::rigidly();
}

std::vector<HandSample> samplesOf(const std::vector<Pose>& moved, const HandFollow& follow, const Vector3& middle_W) {
  std::vector<Pose> hand;
  std::vector<double> arrival;
  for (const Pose& pose : moved) {
    const Pose next = follow.movedWith(pose);
    arrival.push_back(hand.empty() ? 0.0 : arrival.back() + wayBetween(hand.back(), next, middle_W));
    hand.push_back(next);
  }
  std::vector<HandSample> samples{{hand.front(), 0.0}};
  const double length = arrival.back();
  if (!(length > 0.0)) return samples;
  const double count = std::clamp(std::ceil(length / kSpacing), 1.0, kMostSamples);
  std::size_t leg = 1;
  for (double i = 1.0; i <= count; ++i) {
    const double at = length * i / count;
    while (leg + 1 < hand.size() && arrival[leg] < at) ++leg;
    const double own = arrival[leg] - arrival[leg - 1];
    const double share = own > 0.0 ? std::clamp((at - arrival[leg - 1]) / own, 0.0, 1.0) : 1.0;
    samples.push_back({interpolate(hand[leg - 1], hand[leg], share), i / count});
  }
  return samples;
}

}  // namespace glissade
