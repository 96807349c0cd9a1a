#include "engine/planning/interactive/shown_way.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

// Lengths in radii of the object.
constexpr double kSpacing = 0.05;      ///< distance between two points
constexpr double kStride = 0.5;        ///< a longer step is a new place, not a movement
constexpr double kLeastSpread = 0.02;  ///< least spread, so that members also search about an exact hand
constexpr double kPushed = 0.25;       ///< length of the latest movement, which gives the direction of the push
constexpr double kReach = 1.0;         ///< length of the push beyond the hand that members search
/// Points that are kept. When they are full the older half is forgotten.
constexpr std::size_t kMostPoints = 1500;
/// Number of configurations over which the spread is averaged.
constexpr double kMemory = 50.0;

}  // namespace

void WayRecorder::add(const Pose& q, const NearestObstacle& nearest, double moved) {
  meanSquare_ += (moved * moved - meanSquare_) / kMemory;
  const bool free = nearest.distance > 0.0;  // a hand deep in an obstacle shows nothing
  const bool touches = free && (moved > 0.0 || nearest.distance <= kSpacing * metric_.radius());
  inContact_ += ((touches ? 1.0 : 0.0) - inContact_) / std::min(kMemory, static_cast<double>(++added_));
  const double step = points_.empty() ? 0.0 : metric_.distance(points_.back().q, q);
  if (!points_.empty() && step < kSpacing * metric_.radius()) return;
  if (points_.size() == kMostPoints) points_.erase(points_.begin(), points_.begin() + kMostPoints / 2);
  points_.push_back({q, nearest, !points_.empty() && step <= kStride * metric_.radius()});
  ++version_;
}

double WayRecorder::spread() const { return std::hypot(kLeastSpread * metric_.radius(), std::sqrt(meanSquare_)); }

/// The movement that led to the last point, extended to the hand where obstacles hold the object back.
std::optional<ShownWay::Push> WayRecorder::push(const std::optional<Pose>& hand) const {
  if (points_.empty()) return std::nullopt;
  const Pose to = hand.value_or(points_.back().q);
  std::size_t first = points_.size() - 1;
  while (first > 0 && points_[first].follows && metric_.distance(points_[first].q, to) < kPushed * metric_.radius()) {
    --first;
  }
  const double length = metric_.distance(points_[first].q, to);
  if (length < kLeastSpread * metric_.radius()) return std::nullopt;
  return ShownWay::Push{ScrewDisplacement(points_[first].q, to), 1.0 + kReach * metric_.radius() / length};
}

}  // namespace glissade
