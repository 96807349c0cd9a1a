#include "engine/check/kept_directions.h"

#include <algorithm>
#include <cmath>

#include "engine/base/tolerances.h"
#include "engine/check/hull_clearance.h"
#include "engine/check/motion_geometry.h"

namespace glissade::check {
namespace {

/// Share of the body's size. A shorter displacement does not count as a motion.
constexpr double kUnmoved = 2e-6;
/// Tolerance of the cosine for rounding: beyond it a direction is forbidden.
constexpr double kRoundingOfCosine = 1e-9;

double touchingDistance(const Body& body) { return tolerance::kTouching * radiusAboutOrigin(*body.mesh); }

distances::Model scaledSurface(const TriangleMesh& placed, double scale) {
  distances::Model surface;
  surface.beginModel();
  distances::addTriangles(surface, scaled(placed, Vector3::Constant(scale)));
  surface.endModel();
  return surface;
}

bool areTouching(const Body& body, const Body& other, double distance) {
  const TriangleMesh own = transformed(*body.mesh, body.X_WB);
  const TriangleMesh theirs = transformed(*other.mesh, other.X_WB);
  if (boundingBox(own).exteriorDistance(boundingBox(theirs)) > distance) return false;
  const double scale = fclScale({&own, &theirs}, 0.0);
  const auto gap = distances::between(scaledSurface(theirs, scale), scaledSurface(own, scale),
                                      fcl::Transform3d::Identity(), 2.0 * distance * scale);
  return gap.min_distance <= distance * scale;
}

/// The configurations of the path, with intermediate ones so that no piece turns far.
std::vector<Pose> inPieces(const std::vector<Pose>& path) {
  std::vector<Pose> all{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double turn = angleBetween(path[i - 1].orientation, path[i].orientation);
    const double pieces = std::max(1.0, std::ceil(turn / tolerance::kMotionPiece));
    for (double piece = 1.0; piece < pieces; piece += 1.0) {
      all.push_back(interpolate(path[i - 1], path[i], piece / pieces));
    }
    all.push_back(path[i]);
  }
  return all;
}

bool isClear(const ForbiddenMotion& forbidden, const Pose& X_WB) {
  const double distance = touchingDistance(forbidden.body);
  return std::all_of(forbidden.beside.begin(), forbidden.beside.end(), [&](const Body* other) {
    return hullsAreClear(*forbidden.body.mesh, X_WB, *other->mesh, other->X_WB, distance);
  });
}

}  // namespace

std::vector<std::size_t> touching(const Product& product, std::size_t body) {
  const double distance = touchingDistance(product.bodies[body]);
  std::vector<std::size_t> all;
  std::vector<std::size_t> near;
  for (std::size_t other = 0; other < product.bodies.size(); ++other) {
    if (other == body) continue;
    all.push_back(other);
    if (areTouching(product.bodies[body], product.bodies[other], distance)) near.push_back(other);
  }
  return near.empty() ? all : near;
}

bool keepsOut(const ForbiddenMotion& forbidden, const std::vector<Pose>& path) {
  const std::vector<Pose> places = inPieces(path);
  const Box3 box = boundingBox(*forbidden.body.mesh);
  const Vector3 middle = box.center();
  const Vector3 direction = forbidden.direction.normalized();
  const auto isWrong = [&](const Vector3& way) {
    return way.norm() > 0.5 * kUnmoved * box.diagonal().norm() &&
           direction.dot(way) > (tolerance::kForbiddenCone + kRoundingOfCosine) * way.norm();
  };
  const Vector3 start = places.front() * middle;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Vector3 end = places[i] * middle;
    if (!isWrong(end - places[i - 1] * middle) && !isWrong(end - start)) continue;
    const auto before = places.begin() + static_cast<std::ptrdiff_t>(i);
    // The start does not count: a part that touches nothing may not begin in a forbidden direction either.
    return std::any_of(std::next(places.begin()), before, [&](const Pose& X_WB) { return isClear(forbidden, X_WB); });
  }
  return true;
}

}  // namespace glissade::check
