#include "engine/check/thread_axis.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace glissade::check {
namespace {

constexpr double kOnThreadCylinder = 1e-5;  ///< metres
constexpr double kShareOfThreadRadius = 1e-3;
constexpr std::size_t kFewestVertices = 6;
/// The radii of a shaft and its hole differ by no more than this share of the larger one.
constexpr double kMostDifference = 0.3;
constexpr double kParallel = 1e-4;

/// The first region of the smooth surface that each region is of.
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

struct RoundFace {
  Vector3 point;
  Vector3 axis;
  double radius;
  bool isShaft;  ///< the body is inside of it
};

/// The circle through points that are seen along an axis (I. Kasa, 1976).
std::optional<RoundFace> roundThrough(const std::vector<Vector3>& points, const Vector3& axis) {
  const Vector3 u = axis.unitOrthogonal();
  const Vector3 v = axis.cross(u);
  const Vector3& origin = points.front();
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Vector3 right = Vector3::Zero();
  double scale = 0.0;
  for (const Vector3& p : points) scale = std::max(scale, (p - origin).norm());
  if (!(scale > 0.0)) return std::nullopt;
  for (const Vector3& p : points) {
    const Vector3 row((p - origin).dot(u) / scale, (p - origin).dot(v) / scale, 1.0);
    normal += row * row.transpose();
    right += row * row.head<2>().squaredNorm();
  }
  const Vector3 found = normal.ldlt().solve(right);
  const double squared = found.z() + 0.25 * found.head<2>().squaredNorm();
  if (!found.allFinite() || !(squared > 0.0)) return std::nullopt;
  RoundFace round{origin + 0.5 * scale * (found.x() * u + found.y() * v), axis, scale * std::sqrt(squared), true};
  const double off = std::max(kOnThreadCylinder, kShareOfThreadRadius * round.radius);
  for (const Vector3& p : points) {
    if (std::abs((p - round.point).cross(axis).norm() - round.radius) > off) return std::nullopt;
  }
  return round;
}

/// The direction that the normals of the triangles are across.
Vector3 directionOf(const PlacedBody& body, const std::vector<std::uint32_t>& triangles) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const std::uint32_t t : triangles) sum += body.normals[t] * body.normals[t].transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum);
  return solver.eigenvectors().col(0);
}

/// Of the triangles of a region whose normals are across the direction.
std::optional<RoundFace> roundFaceOf(const PlacedBody& body, const std::vector<std::uint32_t>& triangles,
                                     const Vector3& direction) {
  std::vector<Vector3> points;
  double outwards = 0.0;
  std::vector<std::uint32_t> across;
  for (const std::uint32_t t : triangles) {
    if (std::abs(body.normals[t].dot(direction)) > kParallel || body.normals[t].isZero(0.0)) continue;
    across.push_back(t);
    for (const Vector3& p : body.tree.triangles()[t]) points.push_back(p);
  }
  if (points.size() < 3 * kFewestVertices) return std::nullopt;
  auto round = roundThrough(points, direction);
  if (!round) return std::nullopt;
  for (const std::uint32_t t : across) {
    const Vector3 arm = body.tree.triangles()[t][0] - round->point;
    outwards += body.normals[t].dot(arm - arm.dot(direction) * direction);
  }
  round->isShaft = outwards > 0.0;
  return round;
}

std::vector<RoundFace> roundFacesOf(const PlacedBody& body) {
  std::vector<RoundFace> faces;
  const std::vector<std::uint32_t> surfaceOf = smoothSurfaces(body.regions);
  std::vector<std::vector<std::uint32_t>> byRegion(body.regions.count);
  for (std::uint32_t t = 0; t < body.mesh.triangles.size(); ++t) byRegion[surfaceOf[body.regions.of[t]]].push_back(t);
  for (const auto& triangles : byRegion) {
    if (triangles.size() < kFewestVertices) continue;
    const auto round = roundFaceOf(body, triangles, directionOf(body, triangles));
    if (round) faces.push_back(*round);
  }
  std::vector<std::vector<std::uint32_t>> byFace(body.mesh.faces.size());
  for (std::uint32_t t = 0; t < body.mesh.faceOf.size(); ++t) byFace[body.mesh.faceOf[t]].push_back(t);
  for (std::size_t f = 0; f < byFace.size(); ++f) {
    if (body.mesh.faces[f].kind != SurfaceFace::Kind::Cylinder) continue;
    const auto round = roundFaceOf(body, byFace[f], body.mesh.faces[f].axis.normalized());
    if (round) faces.push_back(*round);
  }
  return faces;
}

/// Along the axis, of vertices at this distance from it; nothing where there are few.
std::optional<std::pair<double, double>> spanOf(const PlacedBody& body, const Vector3& point, const Vector3& axis,
                                                double radius) {
  std::pair<double, double> span{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  std::size_t count = 0;
  const double off = std::max(kOnThreadCylinder, kShareOfThreadRadius * radius);
  for (const Vector3& vertex : body.mesh.vertices) {
    const Vector3 p = vertex - point;
    if (std::abs(p.cross(axis).norm() - radius) > off) continue;
    span = {std::min(span.first, p.dot(axis)), std::max(span.second, p.dot(axis))};
    ++count;
  }
  if (count < kFewestVertices) return std::nullopt;
  return span;
}

bool shareSpan(const PlacedBody& moving, const PlacedBody& other, const Thread& thread) {
  const auto a = spanOf(moving, thread.point, thread.axis, thread.radiusMoving);
  const auto b = spanOf(other, thread.point, thread.axis, thread.radiusOther);
  return a && b && std::min(a->second, b->second) > std::max(a->first, b->first);
}

Diagnostic noThread(const std::string& reason, const std::string& advice) {
  return {ErrorKind::NoPath, "", "", reason, advice};
}

}  // namespace

Thread threadOf(const StatedThread& stated) {
  Thread thread;
  thread.point = stated.point;
  thread.axis = stated.direction.normalized();
  thread.pitch = stated.pitch;
  thread.radiusMoving = stated.radiusMoving;
  thread.radiusOther = stated.radiusOther;
  return thread;
}

Result<Thread> threadAxis(const PlacedBody& moving, const PlacedBody& other,
                          const std::optional<StatedThread>& stated) {
  if (stated) {
    Thread thread = threadOf(*stated);
    const auto wider = roundFacesOf(moving);
    thread.movingIsShaft = std::any_of(wider.begin(), wider.end(), [&](const RoundFace& face) {
      return face.isShaft && std::abs(face.radius - thread.radiusMoving) <= kOnThreadCylinder &&
             (face.point - thread.point).cross(thread.axis).norm() <= kOnThreadCylinder;
    });
    if (thread.axis.allFinite() && thread.axis.norm() > 0.5 && shareSpan(moving, other, thread)) return thread;
    return noThread("the axis that the file states for the thread is not one that the meshes of both bodies show",
                    "Plan again.");
  }
  std::optional<Thread> best;
  double least = std::numeric_limits<double>::infinity();
  const std::vector<RoundFace> others = roundFacesOf(other);
  for (const RoundFace& a : roundFacesOf(moving)) {
    for (const RoundFace& b : others) {
      const double difference = std::abs(a.radius - b.radius);
      const bool coaxial = a.axis.cross(b.axis).norm() < kParallel &&
                           (b.point - a.point).cross(a.axis).norm() <= 2.0 * kOnThreadCylinder;
      if (a.isShaft == b.isShaft || !coaxial || difference >= least) continue;
      if (difference > kMostDifference * std::max(a.radius, b.radius)) continue;
      Thread thread;
      thread.point = a.point;
      thread.axis = a.axis;
      thread.radiusMoving = a.radius;
      thread.radiusOther = b.radius;
      thread.movingIsShaft = a.isShaft;
      if (!shareSpan(moving, other, thread)) continue;
      least = difference;
      best = thread;
    }
  }
  if (best) return *best;
  return noThread("a person calls the pair a thread, but no shaft of the one is on the axis of a hole of the other",
                  "Give the pair another kind.");
}

std::string wrongPitch(const Thread& thread) {
  const double diameter = 2.0 * std::max(thread.radiusMoving, thread.radiusOther);
  const double pitch = std::abs(thread.pitch);
  if (pitch >= kLeastThreadPitch && pitch <= kMostPitchInDiameters * diameter) return {};
  std::ostringstream text;
  text << "a pitch of " << pitch * 1e3 << " mm is none of a thread of " << diameter * 1e3
       << " mm: it has to be from 0.01 mm to two diameters";
  return text.str();
}

}  // namespace glissade::check
