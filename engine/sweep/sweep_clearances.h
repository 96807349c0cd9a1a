#pragma once

#include <vector>

#include "engine/base/work_watch.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/sweep/lattice.h"

namespace glissade {

/// How near a body comes to the points of a lattice of the world during a motion.
struct SweepClearances {
  /// All lengths in spacings of the lattice.
  static constexpr double kReach = 3.0;  ///< larger distances are not told apart
  static constexpr double kSlack = 0.1;

  /// By point, metres: no point of the body's surface is ever nearer. Where the value is below the reach, a point of
  /// the body comes nearer than the value and the slack together. 0 at points where the body passes, or inside which
  /// it is.
  std::vector<float> values;
};

/// Of a body along straight motions between consecutive poses X_WB, at least one. Unfinished after a stop.
///
/// The lattice is divided into ever smaller blocks of points. Each block passes on the pieces of the motion in which
/// the body comes near it. A piece is a straight segment as the body sees it, so that a distance of a segment from a
/// mesh answers for all times of the piece.
SweepClearances sweepClearances(const Lattice& lattice, const TriangleMesh& body, const std::vector<Pose>& path,
                                const WorkWatch& watch);

}  // namespace glissade
