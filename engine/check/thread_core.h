#pragma once

#include <array>
#include <vector>

#include "engine/base/result.h"
#include "engine/check/path.h"
#include "engine/check/placed_body.h"

namespace glissade::check {

/// A thread that is modelled on a shaft, and the core that is left of it where it is taken away. World frame, or that
/// of the shaft's mesh.
struct ThreadCore {
  Vector3 point = Vector3::Zero();  ///< on the axis
  Vector3 axis = Vector3::UnitZ();  ///< unit
  double low = 0.0;                 ///< of the thread, from the point along the axis, metres
  double high = 0.0;
  double radius = 0.0;   ///< of the core, metres
  double crest = 0.0;    ///< radius of the thread, metres
  double hole = 0.0;     ///< radius that the body with the hole leaves free about the axis, metres
  double spacing = 0.0;  ///< of the coordinates of both bodies, metres
  double margin = 0.0;   ///< that remains between the core and the hole, with the thread's play, metres

  /// Of the corner with the farthest way, metres.
  double depth() const { return crest - radius; }
  /// Any order, of cores that are compared number by number.
  bool operator<(const ThreadCore& b) const {
    const auto numbers = [](const ThreadCore& t) {
      const Vector3& p = t.point;
      return std::array{p.x(), p.y(), p.z(), t.axis.x(), t.axis.y(), t.axis.z(), t.low, t.high, t.radius, t.crest};
    };
    return numbers(*this) < numbers(b);
  }
};

/// The axis, the pitch and the crests that a file states for a thread that it takes away.
struct ClaimedThread {
  Vector3 point = Vector3::Zero();
  Vector3 axis = Vector3::UnitZ();
  double pitch = 0.0;
  double crest = 0.0;  ///< radius, metres
};

/// Where the product is assembled. Every claim is compared with the vertices of both bodies:
/// - a ring of vertices of the hole is around the axis, and vertices of the shaft at the crest's radius are;
/// - the shaft has grooves that are as narrow as what the hole leaves free; the thread reaches as far as there is no
///   gap of a pitch between them;
/// - the crests are a helix of one start about the axis with this pitch, to three percent;
/// - the crest is beyond the core by no more than a sharp thread of this pitch is deep, and no more than 0.15 of the
///   diameter.
/// Errors say which of them does not hold.
Result<ThreadCore> threadCoreOf(const PlacedBody& shaft, const PlacedBody& hole, ClaimedThread claim);

/// Of each triangle: whether it is of the thread. It is within the thread's length and nowhere beyond the crests.
std::vector<bool> trianglesOfThread(const TriangleMesh& shaft, const ThreadCore& core);

/// The shaft without its thread: vertices between core and crest, within the thread's length, move across the axis onto
/// the core. Vertices of a triangle that reaches beyond the thread's length stay, so that shank and head are whole.
TriangleMesh withoutThread(const TriangleMesh& mesh, const ThreadCore& core);

/// In a frame where the world's is at this pose.
ThreadCore inFrame(const Pose& X_FW, ThreadCore core);

}  // namespace glissade::check
