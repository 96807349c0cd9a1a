#include "engine/check/helix.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/check/evidence_names.h"
#include "engine/evidence/turn.h"

namespace glissade::check {
namespace {

constexpr double kCircle = 6.283185307179586;
constexpr double kFullCircle = 1.01 * kCircle;
constexpr double kNoEnd = std::numeric_limits<double>::infinity();
/// Range of the rotation of an edge, radians, from which its axis can be computed.
constexpr double kSlightest = 1e-4;
constexpr double kStrongest = 3.0;
/// Largest difference of the axes and leads of the edges of a helix; lengths as a share of the object's reach.
constexpr double kDeviation = 1e-3;
/// Half of the largest angle of a triangle, seen from the axis, for which a profile is computed.
constexpr double kHalfAngle = 0.5;
constexpr int kMostSplits = 12;
/// Limit of the compared parts of triangles; beyond it the edges are proved one by one.
constexpr std::uint64_t kMostHelixParts = 2'000'000;
constexpr double kCircleRounding = 1e-9;
constexpr double kUpwards = 1.0 + 1e-9;

struct Profile {
  TurnedTriangle box{};  ///< distances from the axis, and heights
  bool known = false;    ///< the members below are set
  std::array<Eigen::Vector2d, 3> corners;
  std::array<Eigen::Vector2d, 3> outwards;  ///< unit normals of the sides; zero for a side without length
  std::array<double, 3> border{};           ///< largest coordinate of the corners along each normal
  double low = 0.0;                         ///< range of the second coordinate of the corners
  double high = 0.0;
  double error = 0.0;
  double firstAngle = 0.0;  ///< radians about the axis, with the turns by which the second coordinate is below the lead
  double lastAngle = 0.0;
};

struct Lathe {
  const Helix& helix;
  Vector3 u;
  Vector3 v;
  double core = 0.0;     ///< radius within which no triangle has a profile
  double stretch = 1.0;  ///< largest change of height by motion of points, outside of half of the core

  void setCore(double bore) {
    core = 0.5 * bore;
    if (core > 0.0) stretch = std::sqrt(1.0 + std::pow(helix.lead / (kCircle * 0.5 * core), 2)) * kUpwards;
  }
  double period() const { return helix.lead / stretch; }

  Profile profileOf(const Corners& triangle) const {
    Profile profile;
    profile.box = turned(triangle[0], triangle[1], triangle[2], helix.point, helix.axis);
    if (core <= 0.0 || profile.box.nearest < core) return profile;
    std::array<double, 3> angles{};
    std::array<double, 3> radii{};
    std::array<double, 3> heights{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 p = triangle[i] - helix.point;
      radii[i] = std::hypot(p.dot(u), p.dot(v));
      angles[i] = std::atan2(p.dot(v), p.dot(u));
      heights[i] = p.dot(helix.axis);
    }
    for (std::size_t i = 1; i < 3; ++i) angles[i] = angles[0] + std::remainder(angles[i] - angles[0], kCircle);
    const auto [least, most] = std::minmax_element(angles.begin(), angles.end());
    const double half = 0.5 * (*most - *least);
    if (half > kHalfAngle) return profile;
    const double middle = *least + half;
    double nearest = kNoEnd;
    double farthest = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double along = radii[i] * std::cos(angles[i] - middle);
      nearest = std::min(nearest, along);
      farthest = std::max(farthest, along);
    }
    // At a point between corners, the tangent of the angle is a mean of the corners' tangents, weighted by these
    // lengths too.
    const double root = std::sqrt(farthest / nearest);
    const double angleOff = 2.0 * half * (root - 1.0) / (root + 1.0) + 2.0 * (std::tan(half) - half);
    const double radiusOff = *std::max_element(radii.begin(), radii.end()) * (1.0 - std::cos(half));
    // A chord is inside the circle through its ends, so half of the deviation is taken to either side.
    profile.error = std::hypot(0.5 * radiusOff, angleOff * std::abs(period()) / kCircle) * kUpwards;
    profile.known = true;
    for (std::size_t i = 0; i < 3; ++i) {
      profile.corners[i] = {radii[i] - 0.5 * radiusOff, (heights[i] - helix.lead * angles[i] / kCircle) / stretch};
    }
    const double whole = std::floor(profile.corners[0].y() / period());
    for (Eigen::Vector2d& corner : profile.corners) corner.y() -= whole * period();
    profile.firstAngle = *least + whole * kCircle;
    profile.lastAngle = *most + whole * kCircle;
    addSides(profile);
    return profile;
  }

  static void addSides(Profile& profile) {
    const auto& [a, b, c] = profile.corners;
    profile.low = std::min({a.y(), b.y(), c.y()});
    profile.high = std::max({a.y(), b.y(), c.y()});
    const double sense = (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x() >= 0.0 ? 1.0 : -1.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector2d side = profile.corners[(i + 1) % 3] - profile.corners[i];
      const double length = side.norm();
      profile.outwards[i] = Eigen::Vector2d::Zero();
      if (length > 0.0) profile.outwards[i] = sense / length * Eigen::Vector2d(side.y(), -side.x());
      profile.border[i] = -kNoEnd;
      for (const Eigen::Vector2d& corner : profile.corners) {
        profile.border[i] = std::max(profile.border[i], profile.outwards[i].dot(corner));
      }
    }
  }
};

/// Distance of `other` beyond a side of `one` when it is moved by `by` along the second coordinate.
double beyond(const Profile& one, const Profile& other, double by) {
  double most = -kNoEnd;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector2d& n = one.outwards[i];
    const double least =
        std::min({n.dot(other.corners[0]), n.dot(other.corners[1]), n.dot(other.corners[2])}) + n.y() * by;
    most = std::max(most, least - one.border[i]);
  }
  return most;
}

class HelixPairs {
 public:
  /// Distances are bounded up to `mostFar`, which is at most the core.
  HelixPairs(const Lathe& lathe, double wanted, double mostFar)
      : lathe_(lathe),
        wanted_(wanted),
        mostFar_(mostFar),
        aside_(lathe.core > 0.0 ? 2.0 * std::asin(0.5 * mostFar / lathe.core) : 0.0) {}

  /// Lower bound on the distance of the pair, at least `most` if the distance is larger.
  double bound(const Profile& moving, const Profile& fixed, double most) const {
    const double rise = lathe_.helix.advance;
    const double radial =
        std::max({0.0, moving.box.nearest - fixed.box.farthest, fixed.box.nearest - moving.box.farthest});
    const double along = std::max({0.0, moving.box.low + std::min(0.0, rise) - fixed.box.high,
                                   fixed.box.low - moving.box.high - std::max(0.0, rise)});
    const double boxes = std::hypot(radial, along);
    if (boxes >= most || !moving.known || !fixed.known) return boxes;
    return std::max(boxes, inProfile(moving, fixed, most) - moving.error - fixed.error);
  }

  /// A bound() that divides the triangle with the less precise profile until `wanted` is shown.
  double closeBound(const Corners& moving, const Profile& one, const Corners& fixed, const Profile& other,
                    int splits) const {
    const double whole = bound(one, other, kNoEnd);
    if (whole >= wanted_ || splits == 0 || ++parts_ > kMostHelixParts) return whole;
    double least = kNoEnd;
    const bool splitsMoving = !one.known || (other.known && one.error >= other.error);
    for (const Corners& part : quarters(splitsMoving ? moving : fixed)) {
      const Profile profile = lathe_.profileOf(part);
      least = std::min(least, splitsMoving ? closeBound(part, profile, fixed, other, splits - 1)
                                           : closeBound(moving, one, part, profile, splits - 1));
      if (least < wanted_) return least;
    }
    return least;
  }

 private:
  /// Two points nearer to each other than `mostFar_` differ in angle by at most `aside_`, up to a number of full turns
  /// that the advance permits.
  double inProfile(const Profile& moving, const Profile& fixed, double most) const {
    const double period = lathe_.period();
    const double slack = moving.error + fixed.error;
    const double circles = lathe_.helix.advance / lathe_.helix.lead;
    const double first = (moving.firstAngle - fixed.lastAngle - aside_) / kCircle + std::min(0.0, circles);
    const double last = (moving.lastAngle - fixed.firstAngle + aside_) / kCircle + std::max(0.0, circles);
    double least = std::min(most, mostFar_) + slack;
    for (double turn = std::ceil(first - kCircleRounding); turn <= last + kCircleRounding; turn += 1.0) {
      const double by = turn * period;
      const double shift = std::max(moving.low + by - fixed.high, fixed.low - moving.high - by);
      if (shift >= least) continue;
      least = std::min(least, std::max({shift, beyond(moving, fixed, -by), beyond(fixed, moving, by)}));
    }
    return least;
  }

  static std::array<Corners, 4> quarters(const Corners& whole) {
    const Vector3 ab = 0.5 * (whole[0] + whole[1]);
    const Vector3 bc = 0.5 * (whole[1] + whole[2]);
    const Vector3 ca = 0.5 * (whole[2] + whole[0]);
    return {{{whole[0], ab, ca}, {ab, whole[1], bc}, {ca, bc, whole[2]}, {ab, bc, ca}}};
  }

  const Lathe& lathe_;
  double wanted_;
  double mostFar_;
  double aside_;                     ///< largest angle between points at the distance `mostFar_`, radians
  mutable std::uint64_t parts_ = 0;  ///< number of divided parts
};

/// Triangles turned about the axis, with the bounds of all of them.
struct TurnedAll {
  std::vector<TurnedTriangle> each;
  TurnedTriangle all{kNoEnd, 0.0, kNoEnd, -kNoEnd};

  TurnedAll(const std::vector<Corners>& triangles, const Helix& helix) {
    for (const auto& [a, b, c] : triangles) {
      const TurnedTriangle one = turned(a, b, c, helix.point, helix.axis);
      each.push_back(one);
      all = {std::min(all.nearest, one.nearest), std::max(all.farthest, one.farthest), std::min(all.low, one.low),
             std::max(all.high, one.high)};
    }
  }
};

/// Indices of triangles that come nearer than `most` to the others, which rise by up to `rise` (negative: they sink).
std::vector<std::size_t> nearOnes(const TurnedAll& own, TurnedTriangle others, double rise, double most) {
  others.low += std::min(0.0, rise);
  others.high += std::max(0.0, rise);
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < own.each.size(); ++i) {
    if (apartTurned(own.each[i], others) < most) near.push_back(i);
  }
  return near;
}

/// Rotation vector in the world; zero if its sense is not certain.
Vector3 rotationOf(const Pose& from, const Pose& to) {
  const Eigen::AngleAxisd rotation(to.orientation.toRotationMatrix() * from.orientation.toRotationMatrix().transpose());
  const bool clear = rotation.angle() > kSlightest && rotation.angle() < kStrongest;
  return clear ? Vector3(rotation.angle() * rotation.axis()) : Vector3::Zero();
}

/// A point of the axis of the rotation that takes one pose to the other: the centre of rotation in the plane across it.
Vector3 centreOf(const Pose& from, const Pose& to, const Vector3& rotation) {
  const Vector3 axis = rotation.normalized();
  const Vector3 way = to.position - from.position;
  const Vector3 across = way - way.dot(axis) * axis;
  return 0.5 * (from.position + from.position + across) + 0.5 / std::tan(0.5 * rotation.norm()) * axis.cross(across);
}

/// True if the configurations differ by too little to have an axis.
bool isStill(const Pose& from, const Pose& to, double reach) {
  return angleBetween(from.orientation, to.orientation) < kSlightest &&
         (to.position - from.position).norm() < kSlightest * reach;
}

/// The helix that starts with this edge and extends over the next edges that continue it or stand still; no edges if
/// there is none.
Helix helixFrom(const std::vector<Pose>& path, std::size_t first, double reach) {
  Helix helix;
  helix.first = helix.last = first;
  Vector3 rotations = Vector3::Zero();
  Vector3 centres = Vector3::Zero();
  double circle = 0.0;
  const Vector3 begin = rotationOf(path[first], path[first + 1]);
  const Vector3 way = path[first + 1].position - path[first].position;
  const double slope = way.dot(begin) / std::max(begin.squaredNorm(), kSlightest * kSlightest);
  for (std::size_t edge = first; edge + 1 < path.size(); ++edge) {
    if (isStill(path[edge], path[edge + 1], reach)) {
      helix.last = edge;
      continue;
    }
    const Vector3 rotation = rotationOf(path[edge], path[edge + 1]);
    if (rotation.isZero()) break;
    const Vector3 step = path[edge + 1].position - path[edge].position;
    const bool sameAxis = (rotation.normalized() - begin.normalized()).norm() < kDeviation;
    const bool sameLead = std::abs(step.dot(rotation) / rotation.squaredNorm() - slope) < kDeviation * reach;
    if (!sameAxis || !sameLead) break;
    rotations += rotation;
    circle += rotation.norm();
    centres += rotation.norm() * (centreOf(path[edge], path[edge + 1], rotation) - path[first].position);
    helix.last = edge;
  }
  if (circle < kFullCircle) return helix;
  helix.axis = rotations.normalized();
  helix.point = path[first].position + centres / circle;
  helix.advance = (path[helix.last + 1].position - path[first].position).dot(helix.axis);
  helix.lead = helix.advance / circle * kCircle;
  return helix;
}

/// Upper bound on the deviation of a vertex from the exact motion, including the edges between the configurations.
double offHelix(const Helix& helix, const std::vector<Pose>& path, double reach) {
  const Pose& start = path[helix.first];
  double atEnds = 0.0;
  double bow = 0.0;
  double turn = 0.0;
  for (std::size_t edge = helix.first; edge <= helix.last; ++edge) {
    const double angle = rotationOf(path[edge], path[edge + 1]).norm();
    turn += angle;
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(turn, helix.axis).toRotationMatrix();
    const Vector3 exact =
        helix.point + rotation * (start.position - helix.point) + turn / kCircle * helix.lead * helix.axis;
    const Pose& q = path[edge + 1];
    const Eigen::Matrix3d tilt = q.orientation.toRotationMatrix() - rotation * start.orientation.toRotationMatrix();
    const double off = (q.position - exact).norm() + tilt.norm() * reach;
    atEnds = std::max(atEnds, off);
    const double arm = (q.position - helix.point).cross(helix.axis).norm() + off;
    bow = std::max(bow, arm * (1.0 - std::cos(0.5 * angle)));
  }
  // An edge turns uniformly between its ends; the deviations of the ends in rotation are at most doubled.
  return (2.0 * atEnds + bow) * kUpwards;
}

}  // namespace

std::vector<Helix> helicesOf(const std::vector<Pose>& path, const TriangleMesh& object) {
  double reach = 0.0;
  for (const Vector3& vertex : object.vertices) reach = std::max(reach, vertex.norm());
  std::vector<Helix> helices;
  for (std::size_t edge = 0; edge + 1 < path.size();) {
    Helix helix = helixFrom(path, edge, reach);
    edge = helix.last + 1;
    if (helix.lead == 0.0) continue;
    helix.off = offHelix(helix, path, reach);
    helices.push_back(helix);
  }
  return helices;
}

double helixDistance(const std::vector<Corners>& moving, const std::vector<Corners>& fixed, const Helix& helix,
                     double wanted, double enough, const StopToken& stop) {
  const Vector3 u = helix.axis.unitOrthogonal();
  Lathe lathe{helix, u, helix.axis.cross(u)};
  const TurnedAll one(moving, helix);
  const TurnedAll other(fixed, helix);
  lathe.setCore(std::max(one.all.nearest, other.all.nearest));
  // A line between points that are nearer to each other than the core stays outside of half of the core.
  double least = lathe.core > 0.0 ? std::min(enough, lathe.core) : enough;
  const HelixPairs pairs(lathe, wanted, least);
  std::vector<std::pair<std::size_t, Profile>> profiles;
  for (const std::size_t i : nearOnes(one, other.all, -helix.advance, least)) {
    profiles.emplace_back(i, lathe.profileOf(moving[i]));
  }
  for (const std::size_t k : nearOnes(other, one.all, helix.advance, least)) {
    if (stop.stopRequested()) return 0.0;
    const Profile profile = lathe.profileOf(fixed[k]);
    for (const auto& [i, own] : profiles) {
      double bound = pairs.bound(own, profile, least);
      if (bound >= least) continue;
      if (bound < wanted) bound = pairs.closeBound(moving[i], own, fixed[k], profile, kMostSplits);
      least = std::min(least, bound);
      if (least < wanted) return std::max(0.0, least);
    }
  }
  return std::max(0.0, least);
}

}  // namespace glissade::check
