#pragma once

#include <algorithm>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/check/placed_body.h"

namespace glissade::check {

/// No hook bends by more than this share of the diagonal of its body's box, and by no more than this in metres.
inline constexpr double kMostBendShare = 0.25;
inline constexpr double kMostBend = 0.01;

/// Metres by which a hook of a body bends at most.
inline double mostBendOf(const TriangleMesh& body) {
  return std::min(kMostBend, kMostBendShare * boundingBox(body).diagonal().norm());
}

/// Edges of the path on which the two bodies may meet, by their boxes, go along the direction and do not turn. `body`:
/// the one that moves, `path`: its configurations; `direction`: unit, in which it leaves.
bool goesAlong(const Vector3& direction, const Body& body, const std::vector<Pose>& path, const Body& other);

/// What is asked about a hook.
struct HookQuestion {
  const PlacedBody& hook;  ///< the body that leaves, where it is assembled
  const PlacedBody& edge;  ///< the body that it is hooked into
  Vector3 direction;       ///< unit: the way in which the hook's body leaves
  double bend = 0.0;       ///< metres, > 0, that the hook bends
};

/// Of each region of the hook's body, whether it is a face of a hook: the other body is in the way of a quarter of it
/// or more, and it does not face the way out, because a hook bends across that. The way is followed from points a
/// little below the face, on a grid of half the bend, or coarser on large faces. Where the other body is in the way
/// between these points only, the face is taken for none of a hook: less is allowed then, never more.
std::vector<bool> hookRegions(const HookQuestion& question, const StopToken& stop);

}  // namespace glissade::check
