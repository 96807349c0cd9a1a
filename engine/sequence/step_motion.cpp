#include "engine/sequence/step_motion.h"

#include <cmath>

namespace glissade {
namespace {

constexpr double kLeastLength = 1e-7;    ///< metres
constexpr double kLeastTurn = 1e-5;      ///< radians
constexpr double kNearlySameWay = 0.02;  ///< distance of unit vectors

MotionLeg legOf(const Pose& from, const Pose& to) {
  MotionLeg leg;
  const Vector3 moved = to.position - from.position;
  if (moved.norm() > kLeastLength) {
    leg.length = moved.norm();
    leg.direction = moved / leg.length;
  }
  const Eigen::AngleAxisd turned(to.orientation.normalized() * from.orientation.normalized().conjugate());
  const bool isLong = turned.angle() > std::acos(-1.0);
  const double angle = isLong ? 2.0 * std::acos(-1.0) - turned.angle() : turned.angle();
  if (angle > kLeastTurn) {
    leg.turn = angle;
    leg.axis = isLong ? Vector3(-turned.axis()) : turned.axis();
  }
  return leg;
}

bool continues(const MotionLeg& leg, const MotionLeg& next) {
  return (leg.direction - next.direction).norm() < kNearlySameWay && (leg.axis - next.axis).norm() < kNearlySameWay;
}

}  // namespace

std::vector<MotionLeg> legsOf(const std::vector<PathPoint>& path) {
  std::vector<MotionLeg> legs;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const MotionLeg leg = legOf(path[i - 1].q, path[i].q);
    if (leg.length == 0.0 && leg.turn == 0.0) continue;
    if (!legs.empty() && continues(legs.back(), leg)) {
      legs.back().length += leg.length;
      legs.back().turn += leg.turn;
    } else {
      legs.push_back(leg);
    }
  }
  return legs;
}

std::vector<MotionLeg> reversed(const std::vector<MotionLeg>& legs) {
  std::vector<MotionLeg> back(legs.rbegin(), legs.rend());
  for (MotionLeg& leg : back) {
    leg.direction = -leg.direction;
    leg.axis = -leg.axis;
  }
  return back;
}

Vector3 firstDirection(const std::vector<PathPoint>& path) {
  for (const MotionLeg& leg : legsOf(path)) {
    if (leg.length > 0.0) return leg.direction;
  }
  return Vector3::Zero();
}

Vector3 exitDirection(const std::vector<PathPoint>& path) {
  const Vector3 moved = path.back().q.position - path.front().q.position;
  return moved.norm() > kLeastLength ? Vector3(moved.normalized()) : Vector3(Vector3::UnitZ());
}

std::optional<Vector3> axisNamed(std::string_view text) {
  constexpr std::string_view kAxes = "xyz";
  const std::size_t axis = text.size() == 2 ? kAxes.find(text[1]) : std::string_view::npos;
  if (axis == std::string_view::npos || (text[0] != '+' && text[0] != '-')) return std::nullopt;
  return Vector3((text[0] == '+' ? 1.0 : -1.0) * Vector3::Unit(static_cast<Eigen::Index>(axis)));
}

}  // namespace glissade
