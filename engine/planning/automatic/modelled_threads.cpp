#include "engine/planning/automatic/modelled_threads.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/geometry/triangle_tree.h"
#include "engine/planning/automatic/screw_refinement.h"

namespace glissade {
namespace {

/// Surfaces are near each other within so many of the bodies' distance, or this share of the object's radius.
constexpr double kNearDistances = 4.0;
constexpr double kNearRadius = 0.02;
/// An object that is farther from all obstacles, as a share of its radius, is in no thread.
constexpr double kApartRadius = 0.1;
/// Patches of a body that are looked at, at most.
constexpr std::size_t kMostPatches = 4000;
/// Both bodies' threads agree within these: shares of the pitch, and a sine.
constexpr double kPitchShare = 0.02;
constexpr double kAxisShare = 0.2;
constexpr double kAxisSine = 0.03;
/// Of the pitch: how far apart two threads are when the object has left.
constexpr double kBeyond = 1.0;
/// The chords of the helix may take this share of the clearance that is shown.
constexpr double kChordShare = 0.2;
constexpr int kFewestPieces = 12;
constexpr int kMostPieces = 1024;
constexpr double kMostPoses = 100'000;
/// Configurations that are looked at before a whole motion is proved.
constexpr int kLooks = 48;

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

/// Of so many triangles a share is looked at, without regard to their order: facets of a thread alternate.
bool isLookedAt(std::size_t index, std::size_t count) {
  if (count <= kMostPatches) return true;
  const auto scattered = static_cast<std::uint32_t>(index * 2654435761U);
  return scattered < static_cast<double>(kMostPatches) / static_cast<double>(count) * 4294967296.0;
}

/// Of the triangles those near the other body.
Patches nearPatches(const std::vector<Triangle>& triangles, const TriangleTree& other, double near) {
  Patches patches;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (!isLookedAt(i, triangles.size())) continue;
    const auto patch = patchOf(triangles[i]);
    if (patch && other.nearest(patch->point, near).distance < near) patches.push_back(*patch);
  }
  return patches;
}

/// Vertices of the whole body in facets that the screw motion moves along themselves, as far from the axis as the
/// thread; of many a part.
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

/// From the facets near the other body, then from the vertices of the whole thread, which is longer.
std::optional<FittedScrew> threadOf(const TriangleTree& near, const TriangleTree& other, double distance,
                                    const TriangleMesh& mesh, const Pose& X_WM) {
  auto thread = fitScrew(nearPatches(near.triangles(), other, distance));
  if (thread) thread->screw = refinedScrew(thread->screw, threadVertices(mesh, X_WM, *thread));
  return thread;
}

/// Where the screw motion moves triangles along themselves that are as far from the axis as the thread.
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

/// Advance after which the threads are beyond each other.
double advanceBeyond(const ModelledThread& thread, double sense) {
  const double beyond = kBeyond * std::abs(thread.screw.pitch);
  return sense > 0.0 ? std::max(0.0, thread.obstacleHigh - thread.objectLow) + beyond
                     : std::min(0.0, thread.obstacleLow - thread.objectHigh) - beyond;
}

/// On the way there is a configuration that is not clear: cheap, and says most of what is in the way.
std::optional<int> blockedOn(CollisionQuery& query, const ScrewAxis& screw, const Pose& from, double advance,
                             double required) {
  for (int i = 1; i <= kLooks; ++i) {
    // Near the beginning most is learnt.
    const Pose q = screwed(screw, from, advance * std::pow(static_cast<double>(i) / kLooks, 2));
    if (!query.clearAbove(q, required)) return query.nearestObstacle(q).body;
  }
  return std::nullopt;
}

/// The motion in pieces whose chords take little of its clearance; empty where it is not proved to be free.
std::vector<Pose> provedScrew(CollisionQuery& query, const ScrewAxis& screw, const Pose& from, double advance,
                              double required) {
  const double enough = query.nearestObstacle(from).distance;
  const double shown = query.screwClearance(from, screw, advance, enough);
  if (shown * (1.0 - 2.0 * kChordShare) <= required) return {};
  const double arm = (from.position - screw.point_W).cross(screw.axis_W).norm();
  const double angle = std::sqrt(8.0 * kChordShare * shown / std::max(arm, 1e-300));
  const double perTurn = std::max<double>(kFewestPieces, std::ceil(2.0 * std::numbers::pi / angle));
  const double pieces = std::ceil(std::abs(advance / screw.pitch) * perTurn);
  if (perTurn > kMostPieces || pieces > kMostPoses) return {};
  std::vector<Pose> poses{from};
  for (double i = 1.0; i <= pieces; i += 1.0) poses.push_back(screwed(screw, from, advance * i / pieces));
  return poses;
}

}  // namespace

std::vector<ModelledThread> findModelledThreads(const CollisionWorld& world, const Pose& at) {
  std::vector<ModelledThread> threads;
  const double apart = world.makeQuery()->distanceUpTo(at, kApartRadius * world.objectRadius());
  if (apart >= kApartRadius * world.objectRadius() || !world.threads().empty()) return threads;
  const double near = std::max(kNearDistances * apart, kNearRadius * world.objectRadius());
  const Vector3 margin = Vector3::Constant(near);
  Box3 objectBox = boundingBox(world.object(), at);
  objectBox = Box3(objectBox.min() - margin, objectBox.max() + margin);
  for (const RigidBody& body : world.obstacles()) {
    const Box3 bodyBox = boundingBox(*body.mesh, body.X_WB);
    if (!objectBox.intersects(bodyBox)) continue;
    const Box3 both(bodyBox.min() - margin, bodyBox.max() + margin);
    const TriangleTree own(placedTriangles(world.object(), at, both));
    const TriangleTree other(placedTriangles(*body.mesh, body.X_WB, objectBox));
    if (own.triangles().empty() || other.triangles().empty()) continue;
    const auto ownThread = threadOf(own, other, near, world.object(), at);
    if (!ownThread) continue;
    const auto otherThread = threadOf(other, own, near, *body.mesh, body.X_WB);
    if (!otherThread || !agree(ownThread->screw, otherThread->screw)) continue;
    for (const ScrewAxis& screw :
         {otherThread->screw, ownThread->screw, middleOf(otherThread->screw, ownThread->screw)}) {
      ModelledThread& thread = threads.emplace_back();
      thread.screw = screw;
      extend(thread.objectLow, thread.objectHigh, world.object(), at, {screw, ownThread->nearest, ownThread->farthest});
      extend(thread.obstacleLow, thread.obstacleHigh, *body.mesh, body.X_WB,
             {screw, otherThread->nearest, otherThread->farthest});
    }
  }
  return threads;
}

ScrewSearch ModelledThreadWays::out(CollisionQuery& query, const Pose& from, double required,
                                    const StopToken& stop) const {
  ScrewSearch search;
  const std::vector<ModelledThread> threads = findModelledThreads(*world_, from);
  search.engaged = !threads.empty();
  if (threads.empty()) return search;
  std::vector<int> blocking;
  for (const ModelledThread& thread : threads) {
    for (const double sense : {1.0, -1.0}) {
      if (stop.stopRequested()) return search;
      const double advance = advanceBeyond(thread, sense);
      if (const auto body = blockedOn(query, thread.screw, from, advance, required)) {
        blocking.push_back(*body);
        continue;
      }
      std::vector<Pose> poses = provedScrew(query, thread.screw, from, advance, required);
      if (poses.empty()) continue;
      search.ways.push_back({std::move(poses), sense * thread.screw.axis_W, sense * advance / thread.screw.pitch});
    }
    if (!search.ways.empty()) break;
  }
  std::stable_sort(search.ways.begin(), search.ways.end(),
                   [](const ScrewWay& a, const ScrewWay& b) { return std::abs(a.turns) < std::abs(b.turns); });
  std::sort(blocking.begin(), blocking.end());
  blocking.erase(std::unique(blocking.begin(), blocking.end()), blocking.end());
  search.blockedBy = std::move(blocking);
  if (search.ways.empty()) search.why = "no screw motion out of the modelled thread is free";
  return search;
}

std::vector<Pose> ModelledThreadWays::between(CollisionQuery& query, const Pose& from, const Pose& to, double required,
                                              const StopToken& stop) const {
  for (const ModelledThread& thread : findModelledThreads(*world_, from)) {
    if (stop.stopRequested()) break;
    const ScrewAxis& screw = thread.screw;
    const double advance = (to.position - from.position).dot(screw.axis_W);
    const Pose reached = screwed(screw, from, advance);
    const double off = (reached.position - to.position).norm() +
                       world_->objectRadius() * angleBetween(reached.orientation, to.orientation);
    if (off > kAxisShare * std::abs(screw.pitch) || blockedOn(query, screw, from, advance, required)) continue;
    std::vector<Pose> poses = provedScrew(query, screw, from, advance, required);
    if (poses.empty()) continue;
    poses.push_back(to);
    return poses;
  }
  return {};
}

}  // namespace glissade
