#include "engine/fits/measurement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace glissade {
namespace {

/// Cosine (30 degrees): without regions, neighbours whose normals differ by less are one smooth surface.
constexpr double kSmoothSurface = 0.866;
/// Sine below which directions are parallel.
constexpr double kParallelSine = 1e-6;
/// Cosine between an edge and the axis of a cylinder below which the edge goes around it.
constexpr double kRoundCosine = 0.5;

double shareOnSegment(const Vector3& p, const Vector3& from, const Vector3& to) {
  const double squared = (to - from).squaredNorm();
  return squared > 0.0 ? std::clamp((p - from).dot(to - from) / squared, 0.0, 1.0) : 0.0;
}

/// origin + t * direction, for t in [low, high]; a point if both are 0.
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
    case MeasureFeature::Kind::Cylinder:
    case MeasureFeature::Kind::Cone:
    case MeasureFeature::Kind::Torus: return {feature.axisPoint, feature.direction, -kEndless, kEndless};
    case MeasureFeature::Kind::Sphere: return {feature.axisPoint, Vector3::UnitX(), 0.0, 0.0};
    default: return {feature.picked, Vector3::UnitX(), 0.0, 0.0};
  }
}

/// Alternating projection is exact for lines; with clamped ends, the second projection ends it (Ericson 2005, section
/// 5.1.9).
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
  return fromPlane(plane, line.at(meets));  // clamped to the nearer end
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
  sides_.reserve(3 * mesh_->triangles.size());
  for (std::size_t i = 0; i < mesh_->triangles.size(); ++i) {
    const auto& [a, b, c] = mesh_->triangles[i];
    const auto triangle = static_cast<std::uint32_t>(i);
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      sides_.push_back({std::min(from, to), std::max(from, to), triangle});
    }
  }
  std::sort(sides_.begin(), sides_.end(), [](const EdgeSide& one, const EdgeSide& other) {
    return std::tie(one.low, one.high, one.triangle) < std::tie(other.low, other.high, other.triangle);
  });
}

MeasurableMesh::EdgeSides MeasurableMesh::sidesOf(std::uint32_t a, std::uint32_t b) const {
  const EdgeSide edge{std::min(a, b), std::max(a, b), 0};
  const auto [first, last] =
      std::equal_range(sides_.begin(), sides_.end(), edge, [](const EdgeSide& one, const EdgeSide& other) {
        return std::tie(one.low, one.high) < std::tie(other.low, other.high);
      });
  return {sides_.data() + (first - sides_.begin()), sides_.data() + (last - sides_.begin())};
}

bool MeasurableMesh::isFeatureEdge(const EdgeSides& sides) const {
  if (sides.last - sides.first != 2) return true;
  const std::uint32_t left = sides.first[0].triangle;
  const std::uint32_t right = sides.first[1].triangle;
  const SurfaceRegions::Label& one = regions_.labels[left];
  const SurfaceRegions::Label& other = regions_.labels[right];
  if (one != other) return true;
  if (one.kind != SurfaceRegions::Kind::Free) return false;
  return faceNormal(*mesh_, mesh_->triangles[left]).dot(faceNormal(*mesh_, mesh_->triangles[right])) < kSmoothSurface;
}

std::optional<Vector3> MeasurableMesh::axisOf(const SurfaceRegions::Label& label) const {
  if (label.kind == SurfaceRegions::Kind::Cylinder) return regions_.cylinders[label.index].direction;
  if (label.kind != SurfaceRegions::Kind::Round) return std::nullopt;
  const SurfaceFace& surface = regions_.rounds[label.index].surface;
  return surface.kind == SurfaceFace::Kind::Sphere ? std::nullopt : std::optional(surface.axis);
}

std::optional<SurfaceRegions::Label> MeasurableMesh::rimOf(std::uint32_t a, std::uint32_t b) const {
  const EdgeSides sides = sidesOf(a, b);
  if (!isFeatureEdge(sides)) return std::nullopt;
  const Vector3 along = (mesh_->vertices[b] - mesh_->vertices[a]).stableNormalized();
  for (const EdgeSide* side = sides.first; side != sides.last; ++side) {
    const SurfaceRegions::Label& label = regions_.labels[side->triangle];
    const auto axis = axisOf(label);
    if (axis && std::abs(along.dot(*axis)) < kRoundCosine) return label;
  }
  return std::nullopt;
}

MeasureFeature MeasurableMesh::roundAt(const SurfaceRegions::Label& label, const Vector3& p) const {
  MeasureFeature feature;
  feature.picked = p;
  if (label.kind == SurfaceRegions::Kind::Cylinder) {
    const CylinderRegion& region = regions_.cylinders[label.index];
    feature.kind = MeasureFeature::Kind::Cylinder;
    feature.direction = region.direction;
    feature.axisPoint = region.point + (p - region.point).dot(region.direction) * region.direction;
    feature.radius = region.radius;
    feature.isHole = !region.shaft;
    return feature;
  }
  const RoundRegion& region = regions_.rounds[label.index];
  const SurfaceFace& surface = region.surface;
  feature.direction = surface.axis;
  feature.axisPoint = surface.point;
  feature.radius = surface.radius;
  feature.isHole = !region.shaft;
  if (surface.kind == SurfaceFace::Kind::Cone) {
    const double height = (p - surface.point).dot(surface.axis);
    feature.kind = MeasureFeature::Kind::Cone;
    feature.axisPoint = surface.point + height * surface.axis;
    feature.radius = coneRadiusAt(surface, height);
    feature.halfAngle = surface.second;
  } else if (surface.kind == SurfaceFace::Kind::Torus) {
    feature.kind = MeasureFeature::Kind::Torus;
    feature.tubeRadius = surface.second;
  } else {
    feature.kind = MeasureFeature::Kind::Sphere;
  }
  return feature;
}

MeasureFeature MeasurableMesh::alignableAt(std::size_t triangle, const Vector3& p, double snap) const {
  const TriangleIndices& corners = mesh_->triangles[triangle];
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = corners[i];
    const std::uint32_t b = corners[(i + 1) % 3];
    const Vector3& from = mesh_->vertices[a];
    const Vector3& to = mesh_->vertices[b];
    if ((from + shareOnSegment(p, from, to) * (to - from) - p).norm() > snap) continue;
    if (const auto round = rimOf(a, b)) return roundAt(*round, p);
  }
  return featureAt(triangle, p, snap);
}

std::vector<Vector3> MeasurableMesh::outlineAt(std::size_t triangle) const {
  const SurfaceRegions::Label& region = regions_.labels[triangle];
  std::vector<Vector3> segments;
  if (region.kind == SurfaceRegions::Kind::Free) return segments;
  const auto isOfRegion = [&](const EdgeSide& side) { return regions_.labels[side.triangle] == region; };
  const EdgeSide* end = sides_.data() + sides_.size();
  for (const EdgeSide* first = sides_.data(); first != end;) {
    const EdgeSides sides{first, std::find_if(first, end, [first](const EdgeSide& side) {
                            return side.low != first->low || side.high != first->high;
                          })};
    if (std::any_of(sides.first, sides.last, isOfRegion) && isFeatureEdge(sides)) {
      segments.insert(segments.end(), {mesh_->vertices[first->low], mesh_->vertices[first->high]});
    }
    first = sides.last;
  }
  return segments;
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
    feature.kind = MeasureFeature::Kind::Edge;
    feature.picked = on;
    feature.from = from;
    feature.to = to;
    feature.direction = (to - from).stableNormalized();
  }
  if (feature.kind == MeasureFeature::Kind::Edge) return feature;
  const SurfaceRegions::Label& label = regions_.labels[triangle];
  feature.picked = p;
  feature.direction = faceNormal(*mesh_, corners);
  if (label.kind == SurfaceRegions::Kind::Plane) {
    feature.kind = MeasureFeature::Kind::Face;
    feature.direction = regions_.planes[label.index].normal;
  } else if (label.kind != SurfaceRegions::Kind::Free) {
    return roundAt(label, p);
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

Pose frameOnAxis(const Vector3& origin, const Vector3& direction) {
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  return frameAlong(origin, direction[largest] < 0.0 ? Vector3(-direction) : direction);
}

}  // namespace

std::optional<Pose> MeasurableMesh::frameAt(std::size_t triangle) const {
  const SurfaceRegions::Label& label = regions_.labels[triangle];
  if (label.kind == SurfaceRegions::Kind::Free) return std::nullopt;
  if (label.kind == SurfaceRegions::Kind::Cylinder) {
    const CylinderRegion& cylinder = regions_.cylinders[label.index];
    return frameOnAxis(cylinder.point + 0.5 * (cylinder.low + cylinder.high) * cylinder.direction, cylinder.direction);
  }
  if (label.kind == SurfaceRegions::Kind::Round) {
    const RoundRegion& round = regions_.rounds[label.index];
    const bool isCone = round.surface.kind == SurfaceFace::Kind::Cone;
    const double middle = isCone ? 0.5 * (round.low + round.high) : 0.0;
    return frameOnAxis(round.surface.point + middle * round.surface.axis, round.surface.axis);
  }
  const Pose plane = frameAlong(Vector3::Zero(), regions_.planes[label.index].normal);
  Box3 box;
  for (std::size_t i = 0; i < mesh_->triangles.size(); ++i) {
    if (regions_.labels[i] != label) continue;
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
    return feature.kind == MeasureFeature::Kind::Edge || isPlane(feature) || feature.isTurned();
  };
  if (!hasDirection(a) || !hasDirection(b)) return std::nullopt;
  const double cosine = std::abs(a.direction.dot(b.direction));
  const double sine = a.direction.cross(b.direction).norm();
  return isPlane(a) == isPlane(b) ? std::atan2(sine, cosine) : std::atan2(cosine, sine);
}

}  // namespace glissade
