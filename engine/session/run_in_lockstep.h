#pragma once

#include <functional>

#include "engine/session/session.h"

namespace glissade {

/// Planner steps between two reports of a run in lockstep.
inline constexpr std::uint64_t kUsualSlice = 200;

/// Starts the session and plans until the run ends or is stopped. `progressed` is called after every slice of steps.
SnapshotPtr runInLockstep(LockstepSession& session, const StopToken& stop, std::uint64_t slice = kUsualSlice,
                          const std::function<void(const SessionSnapshot&)>& progressed = {});

}  // namespace glissade
