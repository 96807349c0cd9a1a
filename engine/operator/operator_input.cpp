#include "engine/operator/operator_input.h"

#include <algorithm>

namespace glissade {
namespace {

constexpr double kViewHeightsPerSecond = 0.08;
constexpr double kFewestRadiiPerSecond = 0.05;
constexpr double kMostRadiiPerSecond = 5.0;
constexpr double kRadiansPerSecond = 1.0;

}  // namespace

OperatorSpeed operatorSpeed(double viewHeight, double objectRadius) {
  return {std::clamp(kViewHeightsPerSecond * viewHeight, kFewestRadiiPerSecond * objectRadius,
                     kMostRadiiPerSecond * objectRadius),
          kRadiansPerSecond};
}

Twist toTwist(const Deflection& deflection, const OperatorFrame& frame) {
  const auto clamped = [](const Vector3& axes) { return axes.cwiseMax(-1.0).cwiseMin(1.0); };
  Twist twist;
  twist.linear_W = frame.R_WV * (frame.speed.linear * clamped(deflection.translation));
  twist.angular_W = frame.R_WV * (frame.speed.angular * clamped(deflection.rotation));
  return twist;
}

Pose integrate(const Pose& X_WB, const Twist& twist, const Box3& bounds, double dt) {
  if (twist.atRest() || dt <= 0.0) return X_WB;
  Pose moved = X_WB;
  moved.position = (X_WB.position + dt * twist.linear_W).cwiseMax(bounds.min()).cwiseMin(bounds.max());
  const double angle = dt * twist.angular_W.norm();
  if (angle > 0.0) {
    moved.orientation =
        (Quaternion(Eigen::AngleAxisd(angle, twist.angular_W.normalized())) * X_WB.orientation).normalized();
  }
  return moved;
}

}  // namespace glissade
