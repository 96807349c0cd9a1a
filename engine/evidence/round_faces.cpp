#include "engine/evidence/round_faces.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/evidence/placed_body.h"
#include "engine/geometry/circle_fit.h"

namespace glissade::evidence {
namespace {

constexpr std::size_t kFewestTriangles = 6;

/// For each region, the first region of its smooth surface.
std::vector<std::uint32_t> smoothSurfaces(const FaceRegions& regions) {
  std::vector<std::uint32_t> first(regions.count, regions.count);
  for (std::uint32_t r = 0; r < regions.count; ++r) {
    if (first[r] != regions.count) continue;
    first[r] = r;
    for (std::vector<std::uint32_t> open{r}; !open.empty();) {
      const std::uint32_t one = open.back();
      open.pop_back();
      for (const std::uint32_t next : regions.next[one]) {
        if (first[next] != regions.count) continue;
        first[next] = r;
        open.push_back(next);
      }
    }
  }
  return first;
}

/// True if an arc with this chord, metres, is a straight line within the tolerance of its vertices. Each plane is a
/// part of a cylinder that is wide enough.
bool isFlat(double radius, double chord) {
  const double rise = radius - std::sqrt(std::max(0.0, radius * radius - 0.25 * chord * chord));
  return rise <= vertexTolerance(radius);
}

/// The cylinder about the axis through the points.
std::optional<RoundFace> roundThrough(const std::vector<Vector3>& points, const Vector3& axis) {
  const auto circle = fitCircle(points, axis);
  if (!circle) return std::nullopt;
  RoundFace round{circle->middle, axis, circle->radius};
  const double off = vertexTolerance(round.radius);
  double chord = 0.0;
  for (const Vector3& p : points) {
    chord = std::max(chord, (p - points.front()).cross(axis).norm());
    if (std::abs((p - round.point).cross(axis).norm() - round.radius) > off) return std::nullopt;
    const double along = (p - round.point).dot(axis);
    round.low = std::min(round.low, along);
    round.high = std::max(round.high, along);
  }
  return isFlat(round.radius, chord) ? std::nullopt : std::optional(round);
}

/// The direction to which the normals of the triangles are perpendicular.
Vector3 directionOf(const PlacedBody& body, const std::vector<std::uint32_t>& triangles) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const std::uint32_t t : triangles) sum += body.normals[t] * body.normals[t].transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum);
  return solver.eigenvectors().col(0);
}

/// The cylinder through the triangles of a region whose normals are perpendicular to the direction.
std::optional<RoundFace> roundFaceOf(const PlacedBody& body, const std::vector<std::uint32_t>& triangles,
                                     const Vector3& direction) {
  std::vector<Vector3> points;
  double outwards = 0.0;
  std::vector<std::uint32_t> across;
  for (const std::uint32_t t : triangles) {
    if (std::abs(body.normals[t].dot(direction)) > kParallelAxes || body.normals[t].isZero(0.0)) continue;
    across.push_back(t);
    for (const Vector3& p : body.tree.triangles()[t]) points.push_back(p);
  }
  if (points.size() < 3 * kFewestTriangles) return std::nullopt;
  auto round = roundThrough(points, direction);
  if (!round) return std::nullopt;
  for (const std::uint32_t t : across) {
    const Vector3 arm = body.tree.triangles()[t][0] - round->point;
    outwards += body.normals[t].dot(arm - arm.dot(direction) * direction);
  }
  round->isShaft = outwards > 0.0;
  return round;
}

/// True if the part lies on the cylinder of the other face, and between its ends.
bool isPartOf(const RoundFace& part, const RoundFace& face) {
  const double off = vertexTolerance(face.radius);
  const double from = (part.point - face.point).dot(face.axis);
  const double sense = part.axis.dot(face.axis) < 0.0 ? -1.0 : 1.0;
  const auto [low, high] = std::minmax({from + sense * part.low, from + sense * part.high});
  return part.isShaft == face.isShaft && std::abs(part.radius - face.radius) <= off &&
         part.axis.cross(face.axis).norm() <= kParallelAxes &&
         (part.point - face.point).cross(face.axis).norm() <= off && low >= face.low - off && high <= face.high + off;
}

}  // namespace

double vertexTolerance(double radius) {
  constexpr double kShareOfRadius = 1e-3;
  return std::max(kOnCylinder, kShareOfRadius * radius);
}

std::vector<RoundFace> roundFacesOf(const PlacedBody& body) {
  std::vector<RoundFace> faces;
  const auto add = [&](const std::optional<RoundFace>& round) {
    const auto holds = [&](const RoundFace& face) { return isPartOf(*round, face); };
    if (round && std::none_of(faces.begin(), faces.end(), holds)) faces.push_back(*round);
  };
  const std::vector<std::uint32_t> surfaceOf = smoothSurfaces(body.regions);
  std::vector<std::vector<std::uint32_t>> byRegion(body.regions.count);
  for (std::uint32_t t = 0; t < body.mesh.triangles.size(); ++t) byRegion[surfaceOf[body.regions.of[t]]].push_back(t);
  for (const auto& triangles : byRegion) {
    if (triangles.size() < kFewestTriangles) continue;
    add(roundFaceOf(body, triangles, directionOf(body, triangles)));
  }
  std::vector<std::vector<std::uint32_t>> byFace(body.mesh.faces.size());
  for (std::uint32_t t = 0; t < body.mesh.faceOf.size(); ++t) byFace[body.mesh.faceOf[t]].push_back(t);
  for (std::size_t f = 0; f < byFace.size(); ++f) {
    if (body.mesh.faces[f].kind != SurfaceFace::Kind::Cylinder) continue;
    add(roundFaceOf(body, byFace[f], body.mesh.faces[f].axis.normalized()));
  }
  return faces;
}

bool isOf(const RoundFace& round, const PlacedBody& body, std::uint32_t triangle) {
  const Triangle& corners = body.tree.triangles()[triangle];
  const double off = vertexTolerance(round.radius);
  const auto isOn = [&](const Vector3& p) {
    const Vector3 from = p - round.point;
    const double along = from.dot(round.axis);
    return along >= round.low - off && along <= round.high + off &&
           std::abs((from - along * round.axis).norm() - round.radius) <= off;
  };
  const Vector3 from = (corners[0] + corners[1] + corners[2]) / 3.0 - round.point;
  const Vector3 across = from - from.dot(round.axis) * round.axis;
  const double outwards = body.normals[triangle].dot(across);
  return std::all_of(corners.begin(), corners.end(), isOn) && (round.isShaft ? outwards > 0.0 : outwards < 0.0);
}

}  // namespace glissade::evidence
