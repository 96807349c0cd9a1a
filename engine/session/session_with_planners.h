#pragma once

#include "engine/session/replay_session.h"
#include "engine/session/session.h"

namespace glissade {

/// Sessions with the caller's planners instead of makePlannerRegistry().
std::unique_ptr<Session> makeThreadedSession(SessionConfig config, PlannerRegistry planners);
std::unique_ptr<LockstepSession> makeLockstepSession(SessionConfig config, PlannerRegistry planners);
std::unique_ptr<ReplaySession> makeReplaySession(const Problem& problem, std::shared_ptr<const RunLog> log,
                                                 ReplayEnd end, PlannerRegistry planners);

}  // namespace glissade
