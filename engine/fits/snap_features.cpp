#include "engine/fits/snap_features.h"

#include <algorithm>
#include <utility>

namespace glissade {
namespace {

constexpr std::size_t kMostPlanes = 40;
constexpr std::size_t kMostAxes = 20;
/// Share of the largest face, or of the longest axis, below which a feature is left out.
constexpr double kLeastShare = 0.02;
/// Axes are equal within this sine and this distance, metres.
constexpr double kOneDirection = 1e-6;
constexpr double kOneAxis = 1e-6;

/// A feature with its size: square metres of a face, metres of an axis.
struct SizedFeature {
  SnapFeature feature;
  double size = 0.0;
};

std::vector<SizedFeature> planesOf(const MeasurableMesh& mesh) {
  const SurfaceRegions& regions = mesh.regions();
  const TriangleMesh& triangles = mesh.mesh();
  std::vector<SizedFeature> planes(regions.planes.size());
  for (std::size_t i = 0; i < triangles.triangles.size(); ++i) {
    if (regions.labels[i].kind != SurfaceRegions::Kind::Plane) continue;
    SizedFeature& plane = planes[regions.labels[i].index];
    const auto& [a, b, c] = triangles.triangles[i];
    const Vector3& corner = triangles.vertices[a];
    plane.size += 0.5 * (triangles.vertices[b] - corner).cross(triangles.vertices[c] - corner).norm();
    plane.feature.triangle = i;
    for (const std::uint32_t vertex : {a, b, c}) plane.feature.box.extend(triangles.vertices[vertex]);
  }
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const PlaneRegion& region = regions.planes[i];
    SnapFeature& plane = planes[i].feature;
    if (plane.box.isEmpty()) continue;
    const Vector3 middle = plane.box.center();
    plane.direction = region.normal;
    plane.point = middle + (region.offset - region.normal.dot(middle)) * region.normal;
  }
  return planes;
}

bool isOneAxis(const SnapFeature& a, const SnapFeature& b) {
  return a.direction.cross(b.direction).norm() < kOneDirection &&
         (b.point - a.point).cross(a.direction).norm() < kOneAxis;
}

/// Merges surfaces with one axis: the first one gives the direction, the middle is that of all.
void addAxis(const SnapFeature& axis, std::vector<SizedFeature>& axes) {
  const auto same =
      std::find_if(axes.begin(), axes.end(), [&](const SizedFeature& one) { return isOneAxis(one.feature, axis); });
  if (same == axes.end()) {
    axes.push_back({axis, axis.box.diagonal().norm()});
    return;
  }
  SnapFeature& merged = same->feature;
  merged.box.extend(axis.box);
  merged.point += (Vector3(merged.box.center()) - merged.point).dot(merged.direction) * merged.direction;
  same->size = merged.box.diagonal().norm();
}

/// The axis from `low` to `high` along the direction from the point.
SnapFeature axisFeature(const Vector3& point, const Vector3& direction, double low, double high) {
  SnapFeature axis;
  axis.kind = SnapFeature::Kind::Axis;
  axis.point = point + 0.5 * (low + high) * direction;
  axis.direction = direction;
  axis.box.extend(Vector3(point + low * direction));
  axis.box.extend(Vector3(point + high * direction));
  return axis;
}

/// The last triangle of each label.
std::vector<std::size_t> triangleOfEach(const SurfaceRegions& regions, SurfaceRegions::Kind kind, std::size_t count) {
  std::vector<std::size_t> triangles(count);
  for (std::size_t i = 0; i < regions.labels.size(); ++i) {
    if (regions.labels[i].kind == kind) triangles[regions.labels[i].index] = i;
  }
  return triangles;
}

void addAxesOf(const SurfaceRegions& regions, SurfaceFace::Kind kind, std::vector<SizedFeature>& axes) {
  const auto triangles = triangleOfEach(regions, SurfaceRegions::Kind::Round, regions.rounds.size());
  for (std::size_t i = 0; i < regions.rounds.size(); ++i) {
    const RoundRegion& round = regions.rounds[i];
    if (round.surface.kind != kind) continue;
    SnapFeature axis = axisFeature(round.surface.point, round.surface.axis, round.low, round.high);
    axis.triangle = triangles[i];
    addAxis(axis, axes);
  }
}

std::vector<SizedFeature> axesOf(const MeasurableMesh& mesh) {
  const SurfaceRegions& regions = mesh.regions();
  const auto triangles = triangleOfEach(regions, SurfaceRegions::Kind::Cylinder, regions.cylinders.size());
  std::vector<SizedFeature> axes;
  for (std::size_t i = 0; i < regions.cylinders.size(); ++i) {
    const CylinderRegion& region = regions.cylinders[i];
    SnapFeature axis = axisFeature(region.point, region.direction, region.low, region.high);
    axis.triangle = triangles[i];
    addAxis(axis, axes);
  }
  addAxesOf(regions, SurfaceFace::Kind::Cone, axes);
  if (axes.empty()) addAxesOf(regions, SurfaceFace::Kind::Torus, axes);
  return axes;
}

void takeLargest(std::vector<SizedFeature> from, std::size_t most, std::vector<SnapFeature>& to) {
  std::stable_sort(from.begin(), from.end(),
                   [](const SizedFeature& a, const SizedFeature& b) { return a.size > b.size; });
  for (std::size_t i = 0; i < std::min(most, from.size()); ++i) {
    if (from[i].size > kLeastShare * from.front().size) to.push_back(from[i].feature);
  }
}

}  // namespace

SnapFeature placed(const SnapFeature& feature, const Pose& X_WB) {
  SnapFeature moved = feature;
  moved.point = X_WB * feature.point;
  moved.direction = X_WB.orientation * feature.direction;
  moved.box.setEmpty();
  for (const auto corner : {Box3::BottomLeftFloor, Box3::BottomRightFloor, Box3::TopLeftFloor, Box3::TopRightFloor,
                            Box3::BottomLeftCeil, Box3::BottomRightCeil, Box3::TopLeftCeil, Box3::TopRightCeil}) {
    moved.box.extend(X_WB * Vector3(feature.box.corner(corner)));
  }
  return moved;
}

std::vector<SnapFeature> findSnapFeatures(const MeasurableMesh& mesh) {
  std::vector<SnapFeature> features;
  takeLargest(planesOf(mesh), kMostPlanes, features);
  takeLargest(axesOf(mesh), kMostAxes, features);
  return features;
}

}  // namespace glissade
