#pragma once

#include <vector>

#include "engine/base/stop_token.h"
#include "engine/check/placed_body.h"

namespace glissade::check {

/// What is asked about a hook.
struct HookQuestion {
  const PlacedBody& hook;  ///< the body that leaves, where it is assembled
  const PlacedBody& edge;  ///< the body that it is hooked into
  Vector3 direction;       ///< unit: the way in which the hook's body leaves
  double bend = 0.0;       ///< metres, > 0, that the hook bends
};

/// The faces of the hook's body that are of a hook: the other body is in the way of a quarter of them or more, and they
/// do not face the way out: a hook bends across it. Looked at
/// are points a little below the face, on a grid of half the bend, or coarser on large faces. What is met at none of
/// them is no hook: less is allowed then, never more.
std::vector<bool> hookRegions(const HookQuestion& question, const StopToken& stop);

}  // namespace glissade::check
