#pragma once

#include <vector>

#include "engine/base/work_watch.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/sweep/lattice.h"

namespace glissade {

/// Distances of a body from the points of a lattice of the world during a motion.
struct SweepClearances {
  /// All lengths in spacings of the lattice.
  static constexpr double kReach = 3.0;  ///< larger distances are not distinguished
  static constexpr double kSlack = 0.1;

  /// By point, metres: lower bound on the distance of the body's surface. If the value is below the reach, a point of
  /// the body comes nearer than the value plus the slack. 0 at points that the body passes or contains.
  std::vector<float> values;
};

/// The clearances of a body along straight motions between consecutive poses X_WB, at least one. Unfinished after a
/// stop.
///
/// The lattice is divided into ever smaller blocks of points. Each block passes on the pieces of the motion in which
/// the body comes near it. A piece is a straight segment in the frame of the body, so that the distance of a segment
/// from a mesh holds for all times of the piece.
SweepClearances sweepClearances(const Lattice& lattice, const TriangleMesh& body, const std::vector<Pose>& path,
                                const WorkWatch& watch);

}  // namespace glissade
