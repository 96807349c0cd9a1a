#include "engine/sequence/led_part.h"

#include <algorithm>
#include <utility>

namespace glissade {
namespace {

/// Shares of the motion. The nearest point is searched no farther than kLook from the present one, so that the part
/// does not jump to another passage of its motion.
constexpr double kLook = 0.04;
constexpr double kStep = 0.002;
/// Limit of the searches in one call, for a hand that moves fast.
constexpr int kMostLooks = 25;

}  // namespace

LedPart::LedPart(StepWay way, const Pose& X_WB) : way_(std::move(way)), assembled_(X_WB), metric_(way_.radius()) {
  if (way_.length() <= 0.0) share_ = 0.0;
}

Pose LedPart::at(double share) const { return way_.movedAt(share * way_.length()) * assembled_; }

void LedPart::lead(const Pose& X_WB) {
  if (isAssembled()) return;
  for (int look = 0; look < kMostLooks; ++look) {
    double nearest = share_;
    double least = metric_.distance(at(share_), X_WB);
    for (double share = std::max(0.0, share_ - kLook); share <= std::min(1.0, share_ + kLook); share += kStep) {
      const double distance = metric_.distance(at(share), X_WB);
      if (distance >= least) continue;
      least = distance;
      nearest = share;
    }
    if (nearest == share_) break;
    share_ = nearest;
  }
  if (share_ <= kSnaps) share_ = 0.0;
}

}  // namespace glissade
