#include "engine/operator/task_operator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/operator/isotropic_noise.h"
#include "engine/operator/minimum_jerk.h"

namespace glissade {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kSpacing = 0.5;  ///< distance of way points, in radii
constexpr double kLongestTurn = std::numbers::pi;

constexpr std::array<TaskLevel, 3> kTaskLevels{{
    {"task-expert", 0.02, 5.0 * kDegree, 0.325, 1.5, 0.20, 0.004},
    {"task-novice", 0.08, 20.0 * kDegree, 0.115, 0.5, 0.40, 0.004},
    {"misleading", 0.0, 0.0, 0.325, 1.5, 0.20, 0.004, true},
}};

}  // namespace

const std::array<TaskLevel, 3>& taskLevels() { return kTaskLevels; }

std::vector<Pose> taskRoute(const std::vector<Pose>& path, const Se3Metric& metric) {
  std::vector<Pose> route;
  const double spacing = kSpacing * metric.radius();
  double left = spacing;  // distance to the next way point
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double length = metric.distance(path[i - 1], path[i]);
    double at = left;
    for (; at < length; at += spacing) route.push_back(interpolate(path[i - 1], path[i], at / length));
    left = at - length;
  }
  if (!path.empty()) route.push_back(path.back());
  return route;
}

TaskOperator::TaskOperator(const TaskLevel& level, std::vector<Pose> route, const Se3Metric& metric, std::uint64_t seed)
    : level_(level), route_(std::move(route)), size_(2.0 * metric.radius()), stream_(seed, "task operator") {}

void TaskOperator::restart() {
  next_ = 0;
  forwards_ = true;
  shown_.reset();
  time_ = 0.0;
  waiting_ = 0.0;
  duration_ = 0.0;
}

Pose TaskOperator::advance(double dt, const OperatorView& view, const Box3& bounds) {
  if (dt <= 0.0 || route_.empty()) return view.q_device;
  if (!shown_ || *shown_ != view.q_device) duration_ = 0.0;  // another source moved the object
  time_ += dt;
  if (duration_ == 0.0) beginMovement(view.q_device, bounds);
  if (waiting_ > 0.0) {
    waiting_ -= dt;
    shown_ = view.q_device;
    return view.q_device;
  }
  elapsed_ = std::min(duration_, elapsed_ + dt);
  Pose shown = interpolate(from_, to_, minimum_jerk::share(elapsed_ / duration_));
  shown.position = shown.position.cwiseMax(bounds.min()).cwiseMin(bounds.max());
  if (elapsed_ >= duration_) duration_ = 0.0;
  shown_ = shown;
  return shown;
}

void TaskOperator::beginMovement(const Pose& from, const Box3& bounds) {
  from_ = from;
  to_ = shownWayPoint(bounds);
  const double way = (to_.position - from_.position).norm() / size_;
  const double turn = angleBetween(from_.orientation, to_.orientation);
  duration_ = tiredness() * std::max({minimum_jerk::kShortest, minimum_jerk::kPeakOverMean * way / level_.linearSpeed,
                                      minimum_jerk::kPeakOverMean * turn / level_.angularSpeed});
  elapsed_ = 0.0;
  waiting_ = tiredness() * level_.reaction;
  if (next_ + 1 >= route_.size()) forwards_ = false;
  if (next_ == 0) forwards_ = true;
  if (route_.size() > 1) next_ = forwards_ ? next_ + 1 : next_ - 1;
}

Pose TaskOperator::shownWayPoint(const Box3& bounds) {
  if (level_.misleads) {
    Pose anywhere;
    for (int axis = 0; axis < 3; ++axis) {
      anywhere.position[axis] = stream_.uniform(bounds.min()[axis], bounds.max()[axis]);
    }
    anywhere.orientation = fromRotationVector(isotropicNoise(stream_, kLongestTurn));
    return anywhere;
  }
  const Pose& point = route_[next_];
  Pose shown;
  shown.position = point.position + isotropicNoise(stream_, level_.positionError * size_);
  shown.orientation = (fromRotationVector(isotropicNoise(stream_, level_.angleError)) * point.orientation).normalized();
  return shown;
}

}  // namespace glissade
