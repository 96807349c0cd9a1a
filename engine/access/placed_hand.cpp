#include "engine/access/placed_hand.h"

#include <algorithm>

namespace glissade {
namespace {

/// The first of the nearest samples.
std::size_t nearestSample(const std::vector<HandSample>& samples, const Pose& moved, const Vector3& hand_W) {
  const auto distance = [&](const HandSample& sample) {
    return (sample.moved * hand_W - moved * hand_W).norm() +
           0.1 * angleBetween(sample.moved.orientation, moved.orientation);
  };
  const auto nearest = std::min_element(samples.begin(), samples.end(),
                                        [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  return static_cast<std::size_t>(nearest - samples.begin());
}

}  // namespace

PlacedHand placedHand(const MotionAccess& motion, const Pose& moved) {
  const Pose hand = motion.follow.movedWith(moved);
  const std::size_t sample = nearestSample(motion.samples, hand, motion.hand.hold.X_WH.position);
  const HandHold& hold = motion.hand.holdAt(sample);
  const std::optional<std::size_t>& free = motion.hand.bends[sample];
  const std::size_t bend = free.value_or(hold.firstBend);
  const Pose X_WH = hand * hold.X_WH;
  return {hold.hand, X_WH, X_WH * wristBends()[bend], hold.tool, hand * hold.X_WT, free.has_value()};
}

}  // namespace glissade
