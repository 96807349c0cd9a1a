#include "engine/collision/kernel/motion_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glissade {
namespace {

/// Least margin as a share of the requirement, as in the certificate. A smaller margin counts as below the requirement.
constexpr double kSlimmestMargin = 1e-3;
/// The first violation is found to within this way, as a share of the object's size.
constexpr double kLocated = 1e-3;
constexpr std::uint64_t kMostConfigurations = 200'000;
/// Shorter intervals of time are not halved: poses in them differ by rounding only. It bounds the recursion.
constexpr double kShortestHalf = 0x1p-50;
/// Boxes that are not this much larger than the way they go are not opened: halving time says more. Near contact a
/// swept box meets many others; with less, most of the time goes into pairs of triangles that the next halves rule out.
constexpr double kWorthOpening = 8.0;
/// Triangles this much larger than the way they go are worth a plane between them.
constexpr double kWorthAPlane = 2.0;
/// Ways of more than this many roundings of single precision are long.
constexpr double kFine = 16.0;
float above(double value) { return static_cast<float>(value) * 1.000001F + 1e-37F; }

/// The sense of a turn by half a circle is a matter of rounding: that of half of it is not.
Velocity velocityOf(const StraightMotion& motion, const Pose& from, const Pose& to) {
  Velocity velocity(from, motion.at(0.5));
  velocity.translation_W = to.position - from.position;
  velocity.rotation *= 2.0;
  return velocity;
}

double longestWay(const BoxTree& object, const Velocity& velocity) {
  const double arm = velocity.axis_B.cross(object.centre).norm() + object.reach;
  return (velocity.translation_W.norm() + velocity.rotation * arm) * (1.0 + 1e-12);
}

}  // namespace

MotionSearch::MotionSearch(PairTraversal& traversal, Stacks& stacks, const Pose& from, const Pose& to, double required,
                           SeekViolation seek)
    : traversal_(traversal),
      motion_(from, to),
      velocity_(velocityOf(motion_, from, to)),
      longest_(longestWay(traversal.object, velocity_)),
      middle_(from),
      required_(required),
      seek_(seek),
      doubts_(stacks.doubts),
      open_(stacks.open) {}

MotionCheck MotionSearch::run(const StopToken& stop) {
  const BoxPair roots;
  doubts_.assign(1, {roots, true, 1U});
  const Doubts all{0, 1};
  const bool startIsClear = seek_ == SeekViolation::Any || prove({0.0, 0.0}, all, stop);
  if (startIsClear && prove({0.0, 1.0}, all, stop)) check_.status = CertificateStatus::Certified;
  return check_;
}

bool MotionSearch::prove(const Interval& interval, const Doubts& doubts, const StopToken& stop) {
  if (stop.stopRequested() || ++check_.configurations > kMostConfigurations) return false;
  const double half = interval.half();
  if (half > 0.0 && half < kShortestHalf) return false;
  const double middle = interval.middle();
  middle_ = motion_.at(middle);
  spin_W_ = velocity_.rotation * (middle_.orientation * velocity_.axis_B);
  traversal_.placed.moveTo(middle_);
  traversal_.placed.sweep(velocity_, half);
  const std::size_t begin = doubts_.size();
  const bool clear = examine(interval, doubts);
  const Doubts left{begin, doubts_.size()};
  if (clear && left.begin == left.end) {
    check_.certified = interval.end;
    return true;
  }
  const double longest = half * longest_;
  const bool violated = !clear || longest <= kSlimmestMargin * required_;
  if (violated) {
    check_.status = CertificateStatus::Violated;
    check_.at = middle;
    if (seek_ == SeekViolation::Any) return false;
  }
  const bool known = check_.status == CertificateStatus::Violated;
  const double located = std::max(required_, kLocated * traversal_.object.reach);
  if (known && (longest <= located || half <= 0.0)) return false;
  const bool proved =
      prove({interval.begin, middle}, left, stop) && !violated && prove({middle, interval.end}, left, stop);
  doubts_.resize(begin);
  return proved;
}

bool MotionSearch::examine(const Interval& interval, const Doubts& doubts) {
  const double half = interval.half();
  if (traversal_.placed.sphereGap() > required_ + half * longest_) return true;
  bool clear = !violating_ || allowedDistance(*violating_);
  for (std::size_t i = doubts.begin; i < doubts.end; ++i) {
    open_.assign(1, doubts_[i]);
    while (clear && !open_.empty()) {
      const Opened opened = open_.back();
      open_.pop_back();
      clear = examine(opened, half);
      if (!clear) open_.push_back(opened);
    }
    doubts_.insert(doubts_.end(), open_.begin(), open_.end());
  }
  return clear;
}

double MotionSearch::sizeOf(const BoxPair& pair) const {
  return std::max(traversal_.obstacles().radius[pair.obstacle], traversal_.object.radius[pair.object]);
}

bool MotionSearch::examine(Opened opened, double half) {
  unsigned doubtful = 0;
  for (unsigned mask = traversal_.withinSweep(opened, above(required_)); mask != 0; mask &= mask - 1) {
    const auto lane = static_cast<unsigned>(__builtin_ctz(mask));
    const BoxPair pair = opened[lane];
    if (sizeOf(pair) < kWorthOpening * traversal_.wayOf(pair.object)) {
      doubtful |= 1U << lane;
    } else if (!traversal_.bothLeaves(pair)) {
      open_.push_back(traversal_.open(pair));
    } else {
      const Finding finding = examine(pair, half);
      if (finding == Finding::Violation) return false;
      if (finding == Finding::Doubtful) doubtful |= 1U << lane;
    }
  }
  if (doubtful != 0) doubts_.push_back({opened.first, opened.obstacle, doubtful});
  return true;
}

MotionSearch::Finding MotionSearch::examine(const BoxPair& leaves, double half) {
  const double way = traversal_.wayOf(leaves.object);
  const float reach = above(required_ + static_cast<double>(traversal_.bendOf(leaves.object)));
  // A way that is long beside the rounding of single precision is decided in single precision, but for what is
  // violated in its middle.
  const bool fine = way < kFine * static_cast<double>(traversal_.placed.slack());
  unsigned doubtful = traversal_.mayMeetInSweep(leaves, reach, !fine);
  if (doubtful == 0) return Finding::Clear;
  const bool worthAPlane = sizeOf(leaves) >= kWorthAPlane * way;  // false of a way beyond all measure
  if (!worthAPlane) return Finding::Doubtful;
  const unsigned exact = fine ? doubtful : doubtful & traversal_.within(leaves, above(required_));
  const std::uint32_t firstObstacle = traversal_.obstacles().leafOf(leaves.obstacle).first;
  const std::uint32_t firstObject = traversal_.object.leafOf(leaves.object).first;
  for (unsigned mask = exact; mask != 0; mask &= mask - 1) {
    const auto bit = static_cast<std::uint32_t>(__builtin_ctz(mask));
    const TrianglePair pair{firstObstacle + bit % lanes::kLeafTriangles, firstObject + bit / lanes::kLeafTriangles};
    const Finding finding = examine(pair, half, way);
    if (finding == Finding::Violation) return finding;
    if (finding == Finding::Clear) doubtful &= ~(1U << bit);
  }
  return doubtful == 0 ? Finding::Clear : Finding::Doubtful;
}

std::optional<TriangleDistance> MotionSearch::allowedDistance(const TrianglePair& pair) const {
  const Triangle& obstacle = traversal_.obstacleTriangle(pair.obstacle);
  const Triangle object = traversal_.placed.triangle(pair.object);
  if (trianglesMeet(obstacle, object)) return std::nullopt;
  const TriangleDistance distance = triangleDistance(obstacle, object);
  return distance.squared < required_ * required_ ? std::nullopt : std::optional(distance);
}

MotionSearch::Finding MotionSearch::examine(const TrianglePair& pair, double half, double way) {
  const std::optional<TriangleDistance> distance = allowedDistance(pair);
  if (!distance) {
    violating_ = pair;
    return Finding::Violation;
  }
  const double reach = required_ + way;
  return distance->squared > reach * reach || keptApart(pair, *distance, half) ? Finding::Clear : Finding::Doubtful;
}

bool MotionSearch::keptApart(const TrianglePair& pair, const TriangleDistance& distance, double half) const {
  if (distance.squared <= 0.0) return false;
  const Vector3 normal = (distance.onB - distance.onA).normalized();
  const double turned = velocity_.rotation * half;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vector3& corner : traversal_.placed.triangle(pair.object)) {
    const Vector3 arm = corner - middle_.position;
    const double towards = std::abs(normal.dot(velocity_.translation_W + spin_W_.cross(arm)));
    // The deviation of a circle from its tangent.
    const double bend = 0.5 * turned * turned * arm.norm();
    lowest = std::min(lowest, normal.dot(corner - distance.onA) - (half * towards + bend) * (1.0 + 1e-9));
  }
  double highest = -std::numeric_limits<double>::infinity();
  for (const Vector3& corner : traversal_.obstacleTriangle(pair.obstacle)) {
    highest = std::max(highest, normal.dot(corner - distance.onA));
  }
  return lowest - highest > required_;
}

}  // namespace glissade
