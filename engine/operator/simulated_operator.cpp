#include "engine/operator/simulated_operator.h"

#include <algorithm>
#include <cmath>

#include "engine/operator/isotropic_noise.h"
#include "engine/operator/minimum_jerk.h"

namespace glissade {
namespace {

// Lengths in the metric. For an object as large as the papers' (r = 1.5 m) these are the published values.
constexpr double kReached = 0.3 / 1.536;  ///< in radii: distance at which the tree has reached a way point
constexpr double kLagging = 0.9 / 1.536;  ///< in radii: distance of the tree behind the hand at which it lags

constexpr double kLongestReach = 2.0;   ///< longest sub-movement, m (and rad)
constexpr double kWaitForTree = 3.0;    ///< seconds of waiting for the tree before going back to it
constexpr double kLinger = 3.0;         ///< seconds at a way point before going on without the tree
constexpr double kSlidingMemory = 1.0;  ///< seconds without contact nodes after which the tree does not slide any more
constexpr double kTremorTime = 0.3;     ///< correlation time, seconds
constexpr double kShortestHesitation = 0.5;  ///< seconds
constexpr double kLongestHesitation = 1.0;   ///< seconds

constexpr std::array<OperatorLevel, 3> kLevels{{
    {"expert", 1.0, 1.5, 0.20, 0.06, 0.10, 0.01, 0.02, 0.05},
    {"default", 0.6, 0.9, 0.25, 0.10, 0.18, 0.03, 0.06, 0.05},
    {"novice", 0.35, 0.5, 0.40, 0.18, 0.30, 0.03, 0.06, 0.30},
}};

Vector3 shortened(const Vector3& v, double longest) {
  const double length = v.norm();
  return length > longest ? Vector3(v * (longest / length)) : v;
}

}  // namespace

const std::array<OperatorLevel, 3>& operatorLevels() { return kLevels; }

const OperatorLevel* findOperatorLevel(std::string_view id) {
  const auto* found = std::find_if(kLevels.begin(), kLevels.end(), [&](const auto& level) { return level.id == id; });
  return found == kLevels.end() ? nullptr : found;
}

SimulatedOperator::SimulatedOperator(const OperatorLevel& level, std::vector<Pose> route, const Se3Metric& metric,
                                     std::uint64_t seed)
    : level_(level), route_(std::move(route)), metric_(metric), stream_(seed, "simulated operator") {}

void SimulatedOperator::restart() {
  target_ = 0;
  shown_.reset();
  movement_ = SubMovement();
  rest_ = 0.0;
  waited_ = 0.0;
  lingered_ = 0.0;
  contactNodes_ = 0;
  sinceContact_ = kSlidingMemory;
  tremor_.setZero();
  tremorAngle_.setZero();
}

Pose SimulatedOperator::advance(double dt, const OperatorView& view, const Box3& bounds) {
  if (dt <= 0.0 || route_.empty()) return view.q_device;
  if (!shown_ || *shown_ != view.q_device) {  // another source moved the object
    aimed_ = view.q_device;
    movement_ = SubMovement();
  }
  chooseTarget(dt, view);
  if (stream_.uniform() < level_.hesitationsPerSecond * dt) {
    rest_ += stream_.uniform(kShortestHesitation, kLongestHesitation);
  }
  if (rest_ > 0.0) {
    rest_ -= dt;
  } else if (!waitsForTheTree(dt, view)) {
    aimed_ = integrate(aimed_, follow(dt), bounds, dt);
  }
  Pose shown = withTremor(dt);
  shown.position = shown.position.cwiseMax(bounds.min()).cwiseMin(bounds.max());
  shown_ = shown;
  return shown;
}

/// True while contact sampling adds nodes, so that the tree slides.
bool SimulatedOperator::seesTheTreeSlide(double dt, const OperatorView& view) {
  sinceContact_ = view.contactNodes == contactNodes_ ? sinceContact_ + dt : 0.0;
  contactNodes_ = view.contactNodes;
  return sinceContact_ < kSlidingMemory;
}

void SimulatedOperator::chooseTarget(double dt, const OperatorView& view) {
  const bool slides = seesTheTreeSlide(dt, view);
  if (target_ + 1 >= route_.size()) return;
  const Pose& target = route_[target_];
  const bool there = metric_.distance(aimed_, target) <= kReached * metric_.radius();
  lingered_ = there && !slides ? lingered_ + dt : 0.0;
  const double away = view.distanceToStartTree(target);
  const bool impatient = lingered_ > kLinger && away <= kLagging * metric_.radius();
  // A sliding tree comes only as near as the surface below the hand.
  const double near = kReached * metric_.radius() + (there && slides ? view.clearance() : 0.0);
  if (away > near && !impatient) return;
  ++target_;
  lingered_ = 0.0;
  movement_ = SubMovement();
}

bool SimulatedOperator::waitsForTheTree(double dt, const OperatorView& view) {
  const double lag = view.distanceToStartTree(aimed_);
  const bool lags = std::isfinite(lag) && lag > kLagging * metric_.radius();
  if (!lags) {
    waited_ = 0.0;
    return false;
  }
  waited_ += dt;
  if (waited_ < kWaitForTree) return true;
  // Goes back towards the tree, one way point at a time; it moves although it lags.
  if (waited_ - dt < kWaitForTree && target_ > 0) {
    --target_;
    movement_ = SubMovement();
  }
  if (waited_ > 2.0 * kWaitForTree) waited_ = 0.0;
  return false;
}

void SimulatedOperator::beginSubMovement() {
  const Pose& target = route_[target_];
  const Vector3 aimedAt = target.position + isotropicNoise(stream_, level_.aimError);
  const Quaternion turnedTo = fromRotationVector(isotropicNoise(stream_, level_.aimErrorAngle)) * target.orientation;
  movement_.translation = shortened(aimedAt - aimed_.position, kLongestReach);
  movement_.rotation = shortened(rotationVector(aimed_.orientation, turnedTo), kLongestReach);
  movement_.duration = std::max({minimum_jerk::kShortest,
                                 minimum_jerk::kPeakOverMean * movement_.translation.norm() / level_.linearSpeed,
                                 minimum_jerk::kPeakOverMean * movement_.rotation.norm() / level_.angularSpeed});
  movement_.elapsed = 0.0;
}

Twist SimulatedOperator::follow(double dt) {
  if (movement_.elapsed >= movement_.duration) beginSubMovement();
  const double before = minimum_jerk::share(movement_.elapsed / movement_.duration);
  movement_.elapsed = std::min(movement_.duration, movement_.elapsed + dt);
  const double share = (minimum_jerk::share(movement_.elapsed / movement_.duration) - before) / dt;
  if (movement_.elapsed >= movement_.duration) rest_ = level_.delay;
  return {share * movement_.translation, share * movement_.rotation};
}

Pose SimulatedOperator::withTremor(double dt) {
  const double memory = std::exp(-dt / kTremorTime);
  const double fresh = std::sqrt(1.0 - memory * memory);
  tremor_ = memory * tremor_ + fresh * isotropicNoise(stream_, level_.tremor);
  tremorAngle_ = memory * tremorAngle_ + fresh * isotropicNoise(stream_, level_.tremorAngle);
  return {aimed_.position + tremor_, (fromRotationVector(tremorAngle_) * aimed_.orientation).normalized()};
}

}  // namespace glissade
