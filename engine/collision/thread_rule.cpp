#include "engine/collision/thread_rule.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

namespace glissade {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;
/// Share of the radius, and metres. Vertices within either of the thread's cylinder are on it.
constexpr double kOnCylinder = 1e-3;
constexpr double kOnCylinderAtLeast = 5e-6;
/// Largest width of a countersink, in widths of the shaft.
constexpr double kCountersink = 1.25;
/// Largest turn with a certain sense of rotation.
constexpr double kMostTurn = std::numbers::pi - 1e-6;
/// Rounding error of a configuration of a thread that may not turn, metres and radians.
constexpr double kHeldRounding = 1e-9;

/// Angle about a unit axis of the part of a rotation that turns about it, in (-pi, pi].
double turnAbout(const Vector3& axis, const Quaternion& rotation) {
  const double half = std::atan2(rotation.vec().dot(axis), rotation.w());
  return std::remainder(2.0 * half, kFullTurn);
}

/// Range of distances from the axis in which a vertex belongs to a thread.
struct Rim {
  double least;
  double most;
};

/// The rim of a thread. The thread of a shaft ends at the shaft's tip, that of a hole at its countersink.
Rim rimOf(const ThreadRule& rule, bool shaft) {
  const double thick = std::max(rule.radiusOfObject, rule.radiusOfObstacle);
  const double thin = std::min(rule.radiusOfObject, rule.radiusOfObstacle);
  const double off = std::max(kOnCylinderAtLeast, kOnCylinder * thick);
  return shaft ? Rim{0.0, thick + off} : Rim{thin - off, kCountersink * thick};
}

/// Lowest and highest position along the axis.
std::pair<double, double> extentOf(const TriangleMesh& mesh, const Pose& X_WM, const ThreadRule& rule, const Rim& rim) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::pair<double, double> extent{kInfinity, -kInfinity};
  for (const Vector3& vertex : mesh.vertices) {
    const Vector3 p = X_WM * vertex - rule.point_W;
    const double along = p.dot(rule.axis_W);
    const double radius = (p - along * rule.axis_W).norm();
    if (radius < rim.least || radius > rim.most) continue;
    extent = {std::min(extent.first, along), std::max(extent.second, along)};
  }
  return extent;
}

/// Clips the line to the slab along z; false where they do not meet.
bool clipped(Vector3& a, Vector3& b, double low, double high) {
  const auto cut = [](Vector3& end, const Vector3& other, double z) {
    end += (z - end.z()) / (other.z() - end.z()) * (other - end);
  };
  if (std::max(a.z(), b.z()) < low || std::min(a.z(), b.z()) > high) return false;
  for (auto [end, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    if (end->z() < low) cut(*end, *other, low);
    if (end->z() > high) cut(*end, *other, high);
  }
  return true;
}

/// Least distance of a segment from the z axis.
double distanceFromZ(const Vector3& a, const Vector3& b) {
  const Eigen::Vector2d from = a.head<2>();
  const Eigen::Vector2d way = b.head<2>() - from;
  const double length = way.squaredNorm();
  const double t = length > 0.0 ? std::clamp(-from.dot(way) / length, 0.0, 1.0) : 0.0;
  return (from + t * way).norm();
}

}  // namespace

Pose screwed(const ThreadRule& rule, const Pose& from, double advance) {
  return screwed(ScrewAxis{rule.point_W, rule.axis_W, rule.pitch}, from, advance);
}

ThreadPair::ThreadPair(const ThreadRule& rule, const TriangleMesh& object, const RigidBody& obstacle)
    : rule_(rule),
      point_B_(inverse(rule.assembled.front()) * rule.point_W),
      axis_B_(rule.assembled.front().orientation.conjugate() * rule.axis_W) {
  const Rim ofObject = rimOf(rule, rule.objectIsShaft);
  const Rim ofObstacle = rimOf(rule, !rule.objectIsShaft);
  std::tie(object_.low, object_.high) = extentOf(object, rule.assembled.front(), rule, ofObject);
  std::tie(obstacle_.low, obstacle_.high) = extentOf(*obstacle.mesh, obstacle.X_WB, rule, ofObstacle);
}

bool ThreadPair::engagedWithin(const Pose& X_WB, double distance) const {
  const bool objectIsBore = !rule_.objectIsShaft;
  const Span& shaft = objectIsBore ? obstacle_ : object_;
  const Span& bore = objectIsBore ? object_ : obstacle_;
  // Transformation into the bore's own frame, whose axis is z.
  const Vector3 origin = objectIsBore ? Vector3(X_WB * point_B_) : rule_.point_W;
  const Vector3 axis = objectIsBore ? Vector3(X_WB.orientation * axis_B_) : rule_.axis_W;
  const Vector3 shaftOrigin = objectIsBore ? rule_.point_W : Vector3(X_WB * point_B_);
  const Vector3 shaftAxis = objectIsBore ? rule_.axis_W : Vector3(X_WB.orientation * axis_B_);
  const Vector3 u = axis.unitOrthogonal();
  const Vector3 v = axis.cross(u);
  const auto inBore = [&](double along) {
    const Vector3 p = shaftOrigin + along * shaftAxis - origin;
    return Vector3(p.dot(u), p.dot(v), p.dot(axis));
  };
  Vector3 from = inBore(shaft.low);
  Vector3 to = inBore(shaft.high);
  const double margin = distance + this->margin();
  if (!clipped(from, to, bore.low - margin, bore.high + margin)) return false;
  const double radius = objectIsBore ? rule_.radiusOfObject : rule_.radiusOfObstacle;
  return distanceFromZ(from, to) <= radius + margin;
}

double ThreadPair::play() const { return rule_.mayTurn ? kThreadPlay * std::abs(rule_.pitch) : kHeldRounding; }

/// Largest distance of a point of the object's thread between two configurations.
double ThreadPair::offBy(const Pose& X_WB, const Pose& exact) const {
  double off = 0.0;
  for (const double along : {object_.low, object_.high}) {
    const Vector3 p = point_B_ + along * axis_B_;
    off = std::max(off, (X_WB * p - exact * p).norm());
  }
  return off + rule_.radiusOfObject * angleBetween(X_WB.orientation, exact.orientation);
}

double ThreadPair::advanceBetween(const Pose& from, const Pose& to) const {
  return (to * point_B_ - from * point_B_).dot(rule_.axis_W);
}

/// The configuration on the screw motion from an assembled one that is nearest to X_WB.
Pose ThreadPair::nearestOnScrew(const Pose& X_WB, const Pose& assembled) const {
  const double turn = turnAbout(rule_.axis_W, X_WB.orientation * assembled.orientation.conjugate()) / kFullTurn;
  const double advance = advanceBetween(assembled, X_WB);
  const double turns = rule_.mayTurn ? std::round(advance / rule_.pitch - turn) + turn : 0.0;
  return screwed(rule_, assembled, turns * rule_.pitch);
}

bool ThreadPair::isOnScrewOf(const Pose& X_WB, const Pose& assembled) const {
  return isSame(X_WB, nearestOnScrew(X_WB, assembled));
}

/// Two screw motions from one configuration differ by at most the distance of their axes around the thread plus the
/// difference of their pitches.
bool ThreadPair::permitsScrew(const Pose& from, const ScrewAxis& screw, double advance, double off) const {
  if (!rule_.mayTurn) return false;
  const double tilt = screw.axis_W.cross(rule_.axis_W).norm();
  const double apart = (screw.point_W - rule_.point_W).cross(rule_.axis_W).norm();
  const double reach = (screw.point_W - rule_.point_W).norm() + (from * point_B_ - rule_.point_W).norm() +
                       std::max(std::abs(object_.low), std::abs(object_.high)) + rule_.radiusOfObject;
  const double turns = std::abs(advance / screw.pitch);
  const double parted = 2.0 * (apart + tilt * reach) + 2.0 * tilt * std::abs(advance) +
                        turns * std::abs(screw.pitch - rule_.pitch) * (1.0 + kFullTurn * reach / std::abs(rule_.pitch));
  return std::any_of(rule_.assembled.begin(), rule_.assembled.end(), [&](const Pose& assembled) {
    return offBy(from, nearestOnScrew(from, assembled)) + parted + off <= play();
  });
}

bool ThreadPair::isOnScrew(const Pose& X_WB) const {
  return std::any_of(rule_.assembled.begin(), rule_.assembled.end(),
                     [&](const Pose& assembled) { return isOnScrewOf(X_WB, assembled); });
}

bool ThreadPair::isScrewMotion(const Pose& from, const Pose& to) const {
  const double turn = turnAbout(rule_.axis_W, to.orientation * from.orientation.conjugate());
  const Vector3 arm = from.position - rule_.point_W;
  const double radius = (arm - arm.dot(rule_.axis_W) * rule_.axis_W).norm();
  if (std::abs(turn) > kMostTurn || radius * (1.0 - std::cos(0.5 * turn)) > play()) return false;
  if (std::abs(advanceBetween(from, to) - turn / kFullTurn * rule_.pitch) > play()) return false;
  return std::any_of(rule_.assembled.begin(), rule_.assembled.end(),
                     [&](const Pose& assembled) { return isOnScrewOf(from, assembled) && isOnScrewOf(to, assembled); });
}

double ThreadPair::advanceOut(const Pose& from, double sense) const {
  if (!engaged(from)) return 0.0;
  const double at = (from * point_B_ - rule_.point_W).dot(rule_.axis_W);
  return sense > 0.0 ? obstacle_.high - (at + object_.low) : obstacle_.low - (at + object_.high);
}

double turnsWhileEngaged(const ThreadPair& pair, const std::vector<Pose>& path) {
  double turns = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (!pair.engaged(path[i]) && !pair.engaged(path[i + 1])) continue;
    turns += turnAbout(pair.rule().axis_W, path[i + 1].orientation * path[i].orientation.conjugate()) / kFullTurn;
  }
  return turns;
}

}  // namespace glissade
