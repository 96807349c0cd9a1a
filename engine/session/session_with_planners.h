#pragma once

#include "engine/session/session.h"

namespace glissade {

/// Sessions with the caller's planners instead of makePlannerRegistry().
std::unique_ptr<Session> makeThreadedSession(SessionConfig config, PlannerRegistry planners);
std::unique_ptr<LockstepSession> makeLockstepSession(SessionConfig config, PlannerRegistry planners);

}  // namespace glissade
