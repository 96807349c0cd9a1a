#include "engine/check/thread_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace glissade::check {
namespace {

constexpr std::size_t kFewestVertices = 6;
/// Largest relative difference of the radii of a shaft and its hole.
constexpr double kMostDifference = 0.3;

/// Range along the axis of the vertices at this distance from it; nothing if there are few.
std::optional<std::pair<double, double>> spanOf(const PlacedBody& body, const Vector3& point, const Vector3& axis,
                                                double radius) {
  std::pair<double, double> span{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  std::size_t count = 0;
  const double off = vertexTolerance(radius);
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

Diagnostic noThread(const Message& reason, const Message& advice) {
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
    thread.movingIsShaft = std::any_of(moving.rounds.begin(), moving.rounds.end(), [&](const RoundFace& face) {
      return face.isShaft && std::abs(face.radius - thread.radiusMoving) <= kOnCylinder &&
             (face.point - thread.point).cross(thread.axis).norm() <= kOnCylinder;
    });
    if (thread.axis.allFinite() && thread.axis.norm() > 0.5 && shareSpan(moving, other, thread)) return thread;
    return noThread(
        GLISSADE_TEXT("the axis that the file states for the thread is not one that the meshes of both bodies show"),
        GLISSADE_TEXT("Plan again."));
  }
  std::optional<Thread> best;
  double least = std::numeric_limits<double>::infinity();
  for (const RoundFace& a : moving.rounds) {
    for (const RoundFace& b : other.rounds) {
      const double difference = std::abs(a.radius - b.radius);
      const bool coaxial =
          a.axis.cross(b.axis).norm() < kParallelAxes && (b.point - a.point).cross(a.axis).norm() <= 2.0 * kOnCylinder;
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
  return noThread(
      GLISSADE_TEXT("the user calls the pair a thread, but no shaft of the one is on the axis of a hole of the other"),
      GLISSADE_TEXT("Give the pair another kind."));
}

}  // namespace glissade::check
