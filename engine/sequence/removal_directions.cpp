#include "engine/sequence/removal_directions.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/planning/automatic/contact_faces.h"

namespace glissade {
namespace {

constexpr std::size_t kFaces = 6;
constexpr double kAlike = 1.0 - 1e-9;
/// Share of the body's radius.
constexpr double kMargin = 0.05;
/// A direction is upwards or downwards if the sine of its slope is at least this.
constexpr double kUpright = 0.7;

}  // namespace

std::vector<Vector3> removalDirections(const AssembledProduct& product, const ProductFits& fits, std::size_t body) {
  std::vector<Vector3> directions;
  const auto add = [&](const Vector3& direction) {
    const auto alike = [&](const Vector3& other) { return other.dot(direction) > kAlike; };
    if (std::none_of(directions.begin(), directions.end(), alike)) directions.push_back(direction);
  };
  const auto addBoth = [&](const Vector3& direction) {
    add(direction);
    add(-direction);
  };
  // A direction close to an axis of the world is replaced by that axis, without the rounding of fitted cylinders.
  const auto exact = [](const Vector3& direction) {
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(direction[axis]) > kAlike) return Vector3(std::copysign(1.0, direction[axis]) * Vector3::Unit(axis));
    }
    return direction;
  };
  for (std::size_t other = 0; other < product.bodies.size(); ++other) {
    if (const Vector3* way = fits.bentWay(body, other)) add(exact(*way));
  }
  for (const Vector3& axis : fits.axesOf(body)) addBoth(exact(axis));
  for (const int axis : {2, 0, 1}) addBoth(Vector3::Unit(axis));
  const RigidBody& own = product.bodies[body];
  for (const Vector3& normal_B : largestFaceNormals(*own.mesh, kFaces)) addBoth(exact(own.X_WB.orientation * normal_B));
  return directions;
}

int senseOf(const Vector3& direction, const Vector3& up) {
  const double slope = direction.dot(up);
  if (std::abs(slope) < kUpright) return 0;
  return slope > 0.0 ? 1 : -1;
}

double leavingMargin(double radius) { return kMargin * radius; }

double wayOutOf(const Box3& inner, const Box3& outer, const Vector3& direction, double margin) {
  if (outer.isEmpty()) return margin;
  double least = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double speed = std::abs(direction[axis]);
    if (speed < 1e-3) continue;
    const double gap =
        direction[axis] > 0.0 ? outer.max()[axis] - inner.min()[axis] : inner.max()[axis] - outer.min()[axis];
    least = std::min(least, std::max(0.0, gap + margin) / speed);
  }
  return least;
}

double lengthBeside(const Box3& box, const std::vector<Box3>& others, const std::vector<Vector3>& ways) {
  double length = 0.0;
  Vector3 moved = Vector3::Zero();
  for (const Vector3& way : ways) {
    const double whole = way.norm();
    if (whole == 0.0) continue;
    const Box3 own(box.min() + moved, box.max() + moved);
    double beside = 0.0;
    for (const Box3& other : others) beside = std::max(beside, wayOutOf(own, other, way / whole, 0.0));
    length += std::min(beside, whole);
    if (beside <= whole) break;
    moved += way;
  }
  return length;
}

double slideOf(const BodyGroup& group, const std::vector<Vector3>& ways, const BodySet& others, const ProductFits& fits,
               const std::function<Box3(std::size_t body)>& boxOf) {
  double slide = 0.0;
  for (const std::size_t body : group) {
    std::vector<Box3> touched;
    for (const Fit& fit : fits.fitsOf(body)) {
      if (others[fit.obstacle]) touched.push_back(boxOf(fit.obstacle));
    }
    slide = std::max(slide, lengthBeside(boxOf(body), touched, ways));
  }
  return slide;
}

}  // namespace glissade
