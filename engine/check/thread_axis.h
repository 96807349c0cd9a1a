#pragma once

#include <optional>

#include "engine/base/result.h"
#include "engine/check/path.h"
#include "engine/check/placed_body.h"
#include "engine/check/thread.h"

namespace glissade::check {

/// Least pitch of a thread that is made, metres.
inline constexpr double kLeastThreadPitch = 1e-5;
/// Largest pitch, in diameters: a thread with several starts advances by no more in a turn.
inline constexpr double kMostPitchInDiameters = 2.0;

/// The thread with the file's statements only.
Thread threadOf(const StatedThread& stated);

/// The axis of a thread, as a file states it and the meshes confirm it, or found from the meshes. Both bodies have
/// vertices on cylinders about it, within 10 micrometres, on a common range. `other` and `pitch` are not set. Errors
/// state why there is none.
Result<Thread> threadAxis(const PlacedBody& moving, const PlacedBody& other, const std::optional<StatedThread>& stated);

/// The reason why this is no pitch of a thread with these radii; empty if it is one.
Message wrongPitch(const Thread& thread);

}  // namespace glissade::check
