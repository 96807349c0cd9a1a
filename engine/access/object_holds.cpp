#include "engine/access/object_holds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "engine/access/surface_points.h"
#include "engine/geometry/triangle_tree.h"

namespace glissade {
namespace {

constexpr std::size_t kGripPoints = 80;
constexpr int kSides = 8;         ///< number of sides from which a place is gripped
constexpr double kFacing = 0.85;  ///< least cosine between a surface's normal and the direction of the pressure

/// Two places of a surface that face away from each other.
struct PinchedPlace {
  Vector3 middle;
  Vector3 across;  ///< unit
  double thickness;
};

std::vector<PinchedPlace> pinchedPlaces(const TriangleMesh& object_W, double widest) {
  const TriangleTree tree(object_W);
  const double least = 1e-9 * tree.box().diagonal().norm();
  std::vector<PinchedPlace> places;
  for (const SurfacePoint& point : surfacePoints(object_W, kGripPoints)) {
    const double thickness = tree.firstHit(point.p, -point.normal, least);
    if (!(thickness + kPadGap <= widest)) continue;
    const Vector3 other = point.p - thickness * point.normal;
    const auto nearest = tree.nearest(other, std::numeric_limits<double>::infinity());
    const Vector3 normal = faceNormal(object_W, object_W.triangles[nearest.triangle]);
    if (std::abs(normal.dot(point.normal)) < kFacing) continue;
    places.push_back({0.5 * (point.p + other), point.normal, thickness});
  }
  return places;
}

Pose gripFrame(const Vector3& middle, const Vector3& toThumb, const Vector3& into) {
  Eigen::Matrix3d axes;
  axes << toThumb, into.cross(toThumb), into;
  return {middle, Quaternion(axes)};
}

/// Rates how natural a hold is: the forearm is on the exit side, and above; the hand is at the middle of the body.
class Liking {
 public:
  Liking(const Box3& box, Vector3 leaving, Vector3 up)
      : middle_(box.center()),
        radius_(std::max(1e-9, 0.5 * box.diagonal().norm())),
        leaving_(std::move(leaving)),
        up_(std::move(up)) {}

  double of(const Pose& X_WG, const HandHold& hold) const {
    const Vector3 elbow = -(hold.X_WH.orientation * (wristBends()[hold.firstBend].orientation * Vector3::UnitZ()));
    return elbow.dot(leaving_) + 0.3 * elbow.dot(up_) - 0.5 * (X_WG.position - middle_).norm() / radius_;
  }

 private:
  Vector3 middle_;
  double radius_;
  Vector3 leaving_;
  Vector3 up_;
};

/// Number of fingers with room beside each other on the body: four, two or one.
int fingersOn(const TriangleMesh& object_W, const Pose& X_WG, double handBreadth) {
  const Vector3 along = X_WG.orientation * Vector3::UnitY();
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const Vector3& vertex : object_W.vertices) {
    least = std::min(least, along.dot(vertex));
    most = std::max(most, along.dot(vertex));
  }
  const double room = (most - least) / handBreadth;
  if (room > 0.5) return 4;
  return room > 0.3 ? 2 : 1;
}

using RatedHolds = std::vector<std::pair<double, HandHold>>;

/// The holds, best ones first.
std::vector<HandHold> inOrder(RatedHolds rated) {
  std::stable_sort(rated.begin(), rated.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<HandHold> holds;
  holds.reserve(rated.size());
  for (auto& [liked, hold] : rated) holds.push_back(std::move(hold));
  return holds;
}

}  // namespace

std::vector<HandHold> objectHolds(const TriangleMesh& object_W, const Vector3& leaving, const Vector3& up,
                                  HandShapes& shapes) {
  const Liking liking(boundingBox(object_W), leaving, up);
  RatedHolds rated;
  const auto add = [&](const Pose& X_WG, double thickness, double tilt) {
    const int fingers = fingersOn(object_W, X_WG, shapes.measures().handBreadth);
    const auto& shape = shapes.pinch({thickness + kPadGap, fingers, tilt});
    if (!shape) return;
    HandHold hold{shape->mesh, X_WG * inverse(shape->X_HG)};
    const double liked = liking.of(X_WG, hold);
    rated.emplace_back(liked, std::move(hold));
  };
  for (const PinchedPlace& place : pinchedPlaces(object_W, shapes.largestOpening())) {
    const Vector3 aside = place.across.unitOrthogonal();
    for (int side = 0; side < 2 * kSides; ++side) {
      const Vector3 toThumb = side < kSides ? place.across : Vector3(-place.across);
      const Vector3 into = Eigen::AngleAxisd(2.0 * std::numbers::pi * side / kSides, place.across) * aside;
      for (const double back : {0.0, kPadBack * shapes.measures().handBreadth}) {
        const Pose X_WG = gripFrame(place.middle - back * into, toThumb, into);
        for (const double tilt : kPinchTilts) add(X_WG, place.thickness, tilt);
      }
    }
  }
  return inOrder(std::move(rated));
}

std::vector<HandHold> pushHolds(const TriangleMesh& object_W, const Vector3& leaving, HandShapes& shapes) {
  const HandShapes::Shape& shape = shapes.pointing();
  const Vector3 middle = boundingBox(object_W).center();
  RatedHolds rated;
  for (const SurfacePoint& point : surfacePoints(object_W, kGripPoints)) {
    if (point.normal.dot(leaving) < kFacing) continue;
    const Vector3 aside = point.normal.unitOrthogonal();
    for (int side = 0; side < kSides; ++side) {
      const Vector3 across = Eigen::AngleAxisd(2.0 * std::numbers::pi * side / kSides, point.normal) * aside;
      const Pose X_WG = gripFrame(point.p + kPadGap * point.normal, across, -point.normal);
      rated.emplace_back(-(point.p - middle).norm(), HandHold{shape.mesh, X_WG * inverse(shape.X_HG)});
    }
  }
  return inOrder(std::move(rated));
}

}  // namespace glissade
