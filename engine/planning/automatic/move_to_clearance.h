#pragma once

#include "engine/planning/problem.h"

namespace glissade {

/// A configuration near by that keeps twice the required clearance (metres, above 0), so that a planner has room to
/// begin: parts of an assembly touch where CAD puts them, and overlap by what rounding or a press fit leaves. The
/// object is eroded until its contacts have directions, retracted (retraction.h), and asked as it is; the least erosion
/// that leads there counts, up to a thirtieth of its radius. Where none does (a shaft in its hole has nowhere to go),
/// the object slides straight out as far as it has to, along an axis of the world or the normal of one of its faces,
/// on a motion that the eroded object is proved to make. InCollision where that fails too, with the body and how deep
/// it is in it, Interrupted where it was stopped. Deterministic.
Result<Pose> moveToClearance(const CollisionWorldPtr& world, const Pose& q, double required,
                             const StopToken& stop = {});

}  // namespace glissade
