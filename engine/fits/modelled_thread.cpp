#include "engine/fits/modelled_thread.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/fits/screw_fit.h"
#include "engine/fits/screw_refinement.h"
#include "engine/geometry/triangle_tree.h"

namespace glissade {
namespace {

/// Surfaces are near each other within this multiple of the bodies' distance, or this share of the object's radius.
constexpr double kNearDistances = 4.0;
constexpr double kNearRadius = 0.02;
/// Limit of the patches of a body that are examined.
constexpr std::size_t kMostPatches = 4000;
/// Tolerances for the threads of both bodies: shares of the pitch, and a sine.
constexpr double kPitchShare = 0.02;
constexpr double kAxisShare = 0.2;
constexpr double kAxisSine = 0.03;

using Patches = std::vector<SurfacePatch>;

std::vector<Triangle> placedTriangles(const TriangleMesh& mesh, const Pose& X_WM, const Box3& within) {
  std::vector<Triangle> triangles;
  std::vector<Vector3> placed;
  for (const Vector3& vertex : mesh.vertices) placed.push_back(X_WM * vertex);
  for (const auto& [a, b, c] : mesh.triangles) {
    Box3 box(placed[a]);
    box.extend(placed[b]);
    box.extend(placed[c]);
    if (within.intersects(box)) triangles.push_back({placed[a], placed[b], placed[c]});
  }
  return triangles;
}

std::optional<SurfacePatch> patchOf(const Triangle& triangle) {
  const Vector3 across = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const double length = across.norm();
  if (!(length > 0.0)) return std::nullopt;
  return SurfacePatch{(triangle[0] + triangle[1] + triangle[2]) / 3.0, across / length, 0.5 * length};
}

bool agree(const ScrewAxis& a, const ScrewAxis& b) {
  const double sense = a.axis_W.dot(b.axis_W) < 0.0 ? -1.0 : 1.0;
  const double pitch = std::abs(a.pitch);
  return std::abs(a.pitch - b.pitch) <= kPitchShare * pitch && (a.axis_W - sense * b.axis_W).norm() <= kAxisSine &&
         (b.point_W - a.point_W).cross(a.axis_W).norm() <= kAxisShare * pitch;
}

/// Selects a part of many triangles without regard to their order, because facets of a thread alternate.
bool isLookedAt(std::size_t index, std::size_t count) {
  if (count <= kMostPatches) return true;
  const auto scattered = static_cast<std::uint32_t>(index * 2654435761U);
  return scattered < static_cast<double>(kMostPatches) / static_cast<double>(count) * 4294967296.0;
}

/// The triangles near the other body.
Patches nearPatches(const std::vector<Triangle>& triangles, const TriangleTree& other, double near) {
  Patches patches;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (!isLookedAt(i, triangles.size())) continue;
    const auto patch = patchOf(triangles[i]);
    if (patch && other.nearest(patch->point, near).distance < near) patches.push_back(*patch);
  }
  return patches;
}

/// Vertices of the whole body in facets that the screw motion moves along themselves, at the distance of the thread
/// from the axis; a part of them if there are many.
std::vector<Vector3> threadVertices(const TriangleMesh& mesh, const Pose& X_WM, const FittedScrew& thread) {
  std::vector<bool> isOn(mesh.vertices.size(), false);
  const double slack = 0.1 * std::abs(thread.screw.pitch);
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto patch = patchOf({X_WM * mesh.vertices[a], X_WM * mesh.vertices[b], X_WM * mesh.vertices[c]});
    if (!patch || !isMovedAlongItself(thread.screw, *patch)) continue;
    const double radius = (patch->point - thread.screw.point_W).cross(thread.screw.axis_W).norm();
    if (radius >= thread.nearest - slack && radius <= thread.farthest + slack) isOn[a] = isOn[b] = isOn[c] = true;
  }
  const auto count = static_cast<std::size_t>(std::count(isOn.begin(), isOn.end(), true));
  std::vector<Vector3> vertices;
  for (std::size_t i = 0; i < isOn.size(); ++i) {
    if (isOn[i] && isLookedAt(i, count)) vertices.push_back(X_WM * mesh.vertices[i]);
  }
  return vertices;
}

/// Fits the thread to the facets near the other body, then to the vertices of the whole thread, which is longer.
std::optional<FittedScrew> threadOf(const TriangleTree& near, const TriangleTree& other, double distance,
                                    const TriangleMesh& mesh, const Pose& X_WM) {
  auto thread = fitScrew(nearPatches(near.triangles(), other, distance));
  if (thread) thread->screw = refinedScrew(thread->screw, threadVertices(mesh, X_WM, *thread));
  return thread;
}

/// The range of triangles at the thread's distance from the axis that the screw motion moves along themselves.
void extend(double& low, double& high, const TriangleMesh& mesh, const Pose& X_WM, const FittedScrew& thread) {
  low = std::numeric_limits<double>::infinity();
  high = -low;
  const double slack = 0.1 * std::abs(thread.screw.pitch);
  for (const auto& [a, b, c] : mesh.triangles) {
    const Triangle triangle{X_WM * mesh.vertices[a], X_WM * mesh.vertices[b], X_WM * mesh.vertices[c]};
    const auto patch = patchOf(triangle);
    if (!patch || !isMovedAlongItself(thread.screw, *patch)) continue;
    const double radius = (patch->point - thread.screw.point_W).cross(thread.screw.axis_W).norm();
    if (radius < thread.nearest - slack || radius > thread.farthest + slack) continue;
    for (const Vector3& p : triangle) {
      const double along = (p - thread.screw.point_W).dot(thread.screw.axis_W);
      low = std::min(low, along);
      high = std::max(high, along);
    }
  }
}

ScrewAxis middleOf(const ScrewAxis& a, ScrewAxis b) {
  if (a.axis_W.dot(b.axis_W) < 0.0) b.axis_W = -b.axis_W;
  const Vector3 beside = b.point_W + (a.point_W - b.point_W).dot(b.axis_W) * b.axis_W;
  return {0.5 * (a.point_W + beside), (a.axis_W + b.axis_W).normalized(), 0.5 * (a.pitch + b.pitch)};
}

}  // namespace

std::vector<ModelledThread> findModelledThreads(const TriangleMesh& object, const Pose& at, const RigidBody& obstacle,
                                                double apart) {
  const double near = std::max(kNearDistances * apart, kNearRadius * radiusAboutOrigin(object));
  const Vector3 margin = Vector3::Constant(near);
  const auto grown = [&](const Box3& box) { return Box3(box.min() - margin, box.max() + margin); };
  const Box3 objectBox = grown(boundingBox(object, at));
  const Box3 obstacleBox = grown(boundingBox(*obstacle.mesh, obstacle.X_WB));
  std::vector<ModelledThread> threads;
  if (!objectBox.intersects(obstacleBox)) return threads;
  const TriangleTree own(placedTriangles(object, at, obstacleBox));
  const TriangleTree other(placedTriangles(*obstacle.mesh, obstacle.X_WB, objectBox));
  if (own.triangles().empty() || other.triangles().empty()) return threads;
  const auto ownThread = threadOf(own, other, near, object, at);
  if (!ownThread) return threads;
  const auto otherThread = threadOf(other, own, near, *obstacle.mesh, obstacle.X_WB);
  if (!otherThread || !agree(ownThread->screw, otherThread->screw)) return threads;
  for (const ScrewAxis& screw :
       {otherThread->screw, ownThread->screw, middleOf(otherThread->screw, ownThread->screw)}) {
    ModelledThread& thread = threads.emplace_back();
    thread.screw = screw;
    extend(thread.objectLow, thread.objectHigh, object, at, {screw, ownThread->nearest, ownThread->farthest});
    extend(thread.obstacleLow, thread.obstacleHigh, *obstacle.mesh, obstacle.X_WB,
           {screw, otherThread->nearest, otherThread->farthest});
  }
  return threads;
}

}  // namespace glissade
