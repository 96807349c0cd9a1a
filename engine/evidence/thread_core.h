#pragma once

#include <array>
#include <vector>

#include "engine/base/result.h"
#include "engine/evidence/placed_body.h"

namespace glissade::evidence {

/// A thread that is modelled on a shaft, and the core that remains after it is taken away. In the world frame, or in
/// the frame of the shaft's mesh.
struct ThreadCore {
  Vector3 point = Vector3::Zero();  ///< on the axis
  Vector3 axis = Vector3::UnitZ();  ///< unit
  double low = 0.0;                 ///< range of the thread along the axis from `point`, metres
  double high = 0.0;
  double radius = 0.0;   ///< radius of the core, metres
  double crest = 0.0;    ///< radius of the thread, metres
  double hole = 0.0;     ///< radius about the axis that the body with the hole leaves free, metres
  double spacing = 0.0;  ///< spacing of the coordinates of both bodies, metres
  double margin = 0.0;   ///< margin between the core and the hole, with the thread's play, metres

  /// Displacement of the corner that moves farthest, metres.
  double depth() const { return crest - radius; }
  /// An arbitrary order for keys; compares the numbers of the cores.
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
  double pitch = 0.0;  ///< metres a turn
  double crest = 0.0;  ///< radius, metres
};

/// Computes the core where the product is assembled. Each claim is compared with the vertices of both bodies:
/// - a ring of vertices of the hole is around the axis, and so are vertices of the shaft at the crest's radius;
/// - the shaft has grooves as narrow as the free radius of the hole; the thread extends while no gap between them has a
/// pitch;
/// - the crests are a helix about the axis with this pitch, to three percent, of one start or several;
/// - the crest is beyond the core by no more than a sharp thread with as much between its crests is deep, and no more
/// than 0.15 of the
///   diameter.
/// Errors state which claim fails.
Result<ThreadCore> threadCoreOf(const PlacedBody& shaft, const PlacedBody& hole, ClaimedThread claim);

/// For each triangle, true if it belongs to the thread: it is within the thread's length and nowhere beyond the crests.
std::vector<bool> trianglesOfThread(const TriangleMesh& shaft, const ThreadCore& core);

/// The shaft without its thread: vertices between core and crest, within the thread's length, move across the axis onto
/// the core. Vertices of a triangle that extends beyond the thread's length stay, so that shank and head are whole.
TriangleMesh withoutThread(const TriangleMesh& mesh, const ThreadCore& core);

/// The core in a frame F, for a pose X_FW of the world.
ThreadCore inFrame(const Pose& X_FW, ThreadCore core);

}  // namespace glissade::evidence
