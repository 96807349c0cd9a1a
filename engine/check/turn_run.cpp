#include "engine/check/turn_run.h"

#include <algorithm>
#include <cmath>

namespace glissade::check {
namespace {

constexpr double kRunRounding = 1.0 + 1e-9;

/// Angle, radians, of the part of the rotation about the axis.
double twistOf(const Eigen::Matrix3d& rotation, const Vector3& axis) {
  const Quaternion q(rotation);
  return 2.0 * std::atan2(q.vec().dot(axis), q.w());
}

}  // namespace

/// A straight edge between two configurations deviates from the turn by at most twice their deviation, plus its bow.
Rise riseOf(const std::vector<Pose>& path, std::size_t first, std::size_t last, const Vector3& point,
            const Vector3& axis, double reach) {
  const Pose& start = path[first];
  const Eigen::Matrix3d orientation = start.orientation.toRotationMatrix();
  const Vector3 arm = start.position - point;
  Rise rise;
  double atEnds = 0.0;
  double bow = 0.0;
  for (std::size_t i = first + 1; i <= last + 1; ++i) {
    const Pose& q = path[i];
    const Eigen::Matrix3d now = q.orientation.toRotationMatrix();
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(twistOf(now * orientation.transpose(), axis), axis).matrix();
    const double risen = (q.position - start.position).dot(axis);
    rise.least = std::min(rise.least, risen);
    rise.most = std::max(rise.most, risen);
    const Vector3 exact = point + turn * arm + risen * axis;
    const double off = (q.position - exact).norm() + (now - turn * orientation).norm() * reach;
    atEnds = std::max(atEnds, off);
    const Eigen::Matrix3d before = path[i - 1].orientation.toRotationMatrix();
    const double angle = Eigen::AngleAxisd(Eigen::Matrix3d(now * before.transpose())).angle();
    bow = std::max(bow, ((q.position - point).cross(axis).norm() + off) * (1.0 - std::cos(0.5 * angle)));
  }
  rise.off = (2.0 * atEnds + bow) * kRunRounding;
  return rise;
}

}  // namespace glissade::check
