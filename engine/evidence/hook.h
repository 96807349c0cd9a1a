#pragma once

#include <algorithm>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/evidence/placed_body.h"

namespace glissade::evidence {

/// Limits of the bend of a hook: a share of the diagonal of its body's box, and metres.
inline constexpr double kMostBendShare = 0.25;
inline constexpr double kMostBend = 0.01;

/// Largest bend of a hook of the body, metres.
inline double mostBendOf(const TriangleMesh& body) {
  return std::min(kMostBend, kMostBendShare * boundingBox(body).diagonal().norm());
}

/// True if the edges of the path on which the boxes of the two bodies meet go along the direction without turning.
/// `body`: the moving body; `path`: its configurations; `direction`: its exit direction, unit.
bool goesAlong(const Vector3& direction, const Body& body, const std::vector<Pose>& path, const Body& other);

/// The bodies and the bend for which hook faces are found.
struct HookQuestion {
  const PlacedBody& hook;  ///< the body that leaves, where it is assembled
  const PlacedBody& edge;  ///< the body that it is hooked into
  Vector3 direction;       ///< unit exit direction of the hook's body
  double bend = 0.0;       ///< bend of the hook, metres, > 0
};

/// For each region of the hook's body, whether it is a face of a hook: at least a quarter of it is blocked by the other
/// body on the way out, and it does not face the way out, because a hook bends across that direction. Rays start a
/// little below the face, on a grid of half the bend, or coarser on large faces. If the other body blocks the way
/// between sample points only, the face does not count as a hook's, and less is allowed.
std::vector<bool> hookRegions(const HookQuestion& question, const StopToken& stop);

}  // namespace glissade::evidence
