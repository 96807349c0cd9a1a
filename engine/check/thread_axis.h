#pragma once

#include <optional>
#include <string>

#include "engine/base/result.h"
#include "engine/check/path.h"
#include "engine/check/placed_body.h"
#include "engine/check/thread.h"

namespace glissade::check {

/// A pitch below is no thread that is made, metres.
inline constexpr double kLeastThreadPitch = 1e-5;
/// A thread of several starts advances by no more than two of its diameters for a turn: what is steeper is no thread.
inline constexpr double kMostPitchInDiameters = 2.0;

/// As a file states it, and nothing else of it.
Thread threadOf(const StatedThread& stated);

/// The axis of a thread: as a file states it and the meshes show it, or as it is found from the meshes. Both bodies
/// have vertices on cylinders about it, within 10 micrometres, on a common span. `other` and `pitch` are left as they
/// are. Errors say why there is none.
Result<Thread> threadAxis(const PlacedBody& moving, const PlacedBody& other, const std::optional<StatedThread>& stated);

/// Why this is no pitch of a thread of these radii; empty: it is one.
std::string wrongPitch(const Thread& thread);

}  // namespace glissade::check
