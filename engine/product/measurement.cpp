#include "engine/product/measurement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace glissade {
namespace {

/// Neighbours whose normals differ by less are one smooth surface where no region tells them apart: 30 degrees.
constexpr double kSmoothSurface = 0.866;
/// Sine below which directions are parallel.
constexpr double kParallelSine = 1e-6;

std::pair<std::uint32_t, std::uint32_t> edgeKey(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

double shareOnSegment(const Vector3& p, const Vector3& from, const Vector3& to) {
  const double squared = (to - from).squaredNorm();
  return squared > 0.0 ? std::clamp((p - from).dot(to - from) / squared, 0.0, 1.0) : 0.0;
}

/// origin + t * direction, for t in [low, high]; a point where both are 0.
struct MeasuredLine {
  Vector3 origin;
  Vector3 direction;
  double low = 0.0;
  double high = 0.0;

  Vector3 at(double t) const { return origin + std::clamp(t, low, high) * direction; }
  double nearestTo(const Vector3& p) const { return std::clamp((p - origin).dot(direction), low, high); }
};

bool isPlane(const MeasureFeature& feature) { return feature.kind == MeasureFeature::Kind::Face; }

MeasuredLine lineOf(const MeasureFeature& feature) {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  switch (feature.kind) {
    case MeasureFeature::Kind::Edge: return {feature.from, feature.direction, 0.0, (feature.to - feature.from).norm()};
    case MeasureFeature::Kind::Cylinder: return {feature.axisPoint, feature.direction, -kEndless, kEndless};
    default: return {feature.picked, Vector3::UnitX(), 0.0, 0.0};
  }
}

/// Alternating projection is exact for lines at once; with ends clamped, the second projection ends it (Ericson 2005,
/// section 5.1.9).
MeasuredDistance betweenLines(const MeasuredLine& a, const MeasuredLine& b, const Vector3& near) {
  const double c = a.direction.dot(b.direction);
  const Vector3 between = a.origin - b.origin;
  const double denominator = 1.0 - c * c;
  double s = a.nearestTo(near);
  if (a.low != a.high && b.low != b.high && denominator > kParallelSine * kParallelSine) {
    s = std::clamp((c * b.direction.dot(between) - a.direction.dot(between)) / denominator, a.low, a.high);
  }
  const double t = b.nearestTo(a.at(s));
  s = a.nearestTo(b.at(t));
  const Vector3 from = a.at(s);
  const Vector3 to = b.at(b.nearestTo(from));
  return {(to - from).norm(), from, to};
}

MeasuredDistance fromPlane(const MeasureFeature& plane, const Vector3& p) {
  const double height = plane.direction.dot(p - plane.picked);
  return {std::abs(height), p - height * plane.direction, p};
}

MeasuredDistance crossing(const Vector3& p) { return {0.0, p, p}; }

MeasuredDistance betweenPlaneAndLine(const MeasureFeature& plane, const MeasureFeature& other) {
  const MeasuredLine line = lineOf(other);
  const bool parallel = std::abs(plane.direction.dot(line.direction)) < kParallelSine;
  if (line.low == line.high || parallel) return fromPlane(plane, line.at(line.nearestTo(plane.picked)));
  const double meets = plane.direction.dot(plane.picked - line.origin) / plane.direction.dot(line.direction);
  if (meets >= line.low && meets <= line.high) return crossing(line.at(meets));
  return fromPlane(plane, line.at(meets));  // clamped: the nearer end
}

MeasuredDistance swapped(const MeasuredDistance& distance) { return {distance.metres, distance.to, distance.from}; }

}  // namespace

MeasureFeature placed(const MeasureFeature& feature, const Pose& X_WB) {
  MeasureFeature moved = feature;
  moved.picked = X_WB * feature.picked;
  moved.from = X_WB * feature.from;
  moved.to = X_WB * feature.to;
  moved.direction = X_WB.orientation * feature.direction;
  moved.axisPoint = X_WB * feature.axisPoint;
  return moved;
}

MeasurableMesh::MeasurableMesh(MeshPtr mesh) : mesh_(std::move(mesh)), regions_(findSurfaceRegions(*mesh_)) {
  for (std::size_t i = 0; i < mesh_->triangles.size(); ++i) {
    const auto& [a, b, c] = mesh_->triangles[i];
    for (const auto& key : {edgeKey(a, b), edgeKey(b, c), edgeKey(c, a)}) {
      trianglesAt_[key].push_back(static_cast<std::uint32_t>(i));
    }
  }
}

bool MeasurableMesh::isFeatureEdge(std::uint32_t a, std::uint32_t b) const {
  const std::vector<std::uint32_t>& sides = trianglesAt_.at(edgeKey(a, b));
  if (sides.size() != 2) return true;
  const SurfaceRegions::Label& one = regions_.labels[sides[0]];
  const SurfaceRegions::Label& other = regions_.labels[sides[1]];
  if (one.kind != other.kind || one.index != other.index) return true;
  if (one.kind != SurfaceRegions::Kind::Free) return false;
  return faceNormal(*mesh_, mesh_->triangles[sides[0]]).dot(faceNormal(*mesh_, mesh_->triangles[sides[1]])) <
         kSmoothSurface;
}

MeasureFeature MeasurableMesh::featureAt(std::size_t triangle, const Vector3& p, double snap) const {
  const TriangleIndices& corners = mesh_->triangles[triangle];
  MeasureFeature feature;
  double nearest = snap;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = corners[i];
    const std::uint32_t b = corners[(i + 1) % 3];
    const std::uint32_t before = corners[(i + 2) % 3];
    const Vector3& corner = mesh_->vertices[a];
    const bool sharp = isFeatureEdge(a, b) || isFeatureEdge(before, a);
    if (!sharp || (corner - p).norm() > nearest) continue;
    nearest = (corner - p).norm();
    feature.kind = MeasureFeature::Kind::Vertex;
    feature.picked = corner;
  }
  if (feature.kind == MeasureFeature::Kind::Vertex) return feature;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3& from = mesh_->vertices[corners[i]];
    const Vector3& to = mesh_->vertices[corners[(i + 1) % 3]];
    const Vector3 on = from + shareOnSegment(p, from, to) * (to - from);
    if (!isFeatureEdge(corners[i], corners[(i + 1) % 3]) || (on - p).norm() > nearest) continue;
    nearest = (on - p).norm();
    feature = {MeasureFeature::Kind::Edge, on, from, to, (to - from).stableNormalized(), Vector3::Zero(), 0.0};
  }
  if (feature.kind == MeasureFeature::Kind::Edge) return feature;
  const SurfaceRegions::Label& label = regions_.labels[triangle];
  feature.picked = p;
  feature.direction = faceNormal(*mesh_, corners);
  if (label.kind == SurfaceRegions::Kind::Plane) {
    feature.kind = MeasureFeature::Kind::Face;
    feature.direction = regions_.planes[label.index].normal;
  } else if (label.kind == SurfaceRegions::Kind::Cylinder) {
    const CylinderRegion& cylinder = regions_.cylinders[label.index];
    feature.kind = MeasureFeature::Kind::Cylinder;
    feature.direction = cylinder.direction;
    feature.axisPoint = cylinder.point + (p - cylinder.point).dot(cylinder.direction) * cylinder.direction;
    feature.radius = cylinder.radius;
  }
  return feature;
}

namespace {

Pose frameAlong(const Vector3& origin, const Vector3& z) {
  constexpr double kNear = 0.9;
  const Vector3 near = std::abs(z.x()) < kNear ? Vector3::UnitX() : Vector3::UnitY();
  const Vector3 x = (near - near.dot(z) * z).normalized();
  Eigen::Matrix3d axes;
  axes << x, z.cross(x), z;
  return {origin, Quaternion(axes).normalized()};
}

}  // namespace

std::optional<Pose> MeasurableMesh::frameAt(std::size_t triangle) const {
  const SurfaceRegions::Label& label = regions_.labels[triangle];
  if (label.kind == SurfaceRegions::Kind::Free) return std::nullopt;
  if (label.kind == SurfaceRegions::Kind::Cylinder) {
    const CylinderRegion& cylinder = regions_.cylinders[label.index];
    Eigen::Index largest = 0;
    cylinder.direction.cwiseAbs().maxCoeff(&largest);
    const Vector3 axis = cylinder.direction[largest] < 0.0 ? Vector3(-cylinder.direction) : cylinder.direction;
    return frameAlong(cylinder.point + 0.5 * (cylinder.low + cylinder.high) * cylinder.direction, axis);
  }
  const Pose plane = frameAlong(Vector3::Zero(), regions_.planes[label.index].normal);
  Box3 box;
  for (std::size_t i = 0; i < mesh_->triangles.size(); ++i) {
    if (regions_.labels[i].kind != label.kind || regions_.labels[i].index != label.index) continue;
    for (const std::uint32_t corner : mesh_->triangles[i]) box.extend(inverse(plane) * mesh_->vertices[corner]);
  }
  return Pose{plane * Vector3(box.center()), plane.orientation};
}

MeasuredDistance distanceBetween(const MeasureFeature& a, const MeasureFeature& b) {
  if (isPlane(a) && isPlane(b)) {
    const bool parallel = a.direction.cross(b.direction).norm() < kParallelSine;
    return parallel ? fromPlane(a, b.picked) : crossing(a.picked);
  }
  if (isPlane(a)) return betweenPlaneAndLine(a, b);
  if (isPlane(b)) return swapped(betweenPlaneAndLine(b, a));
  return betweenLines(lineOf(a), lineOf(b), b.picked);
}

std::optional<double> angleBetweenFeatures(const MeasureFeature& a, const MeasureFeature& b) {
  const auto hasDirection = [](const MeasureFeature& feature) {
    return feature.kind != MeasureFeature::Kind::Vertex && feature.kind != MeasureFeature::Kind::FreeFace;
  };
  if (!hasDirection(a) || !hasDirection(b)) return std::nullopt;
  const double cosine = std::abs(a.direction.dot(b.direction));
  const double sine = a.direction.cross(b.direction).norm();
  return isPlane(a) == isPlane(b) ? std::atan2(sine, cosine) : std::atan2(cosine, sine);
}

}  // namespace glissade
