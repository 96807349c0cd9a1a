#pragma once

#include "engine/planning/problem.h"

namespace glissade {

/// A configuration near q that keeps twice the required clearance (metres, above 0), so that a planner has room to
/// begin. Parts of an assembly touch where CAD places them, and overlap by rounding or by a press fit. The object is
/// eroded until its contacts have directions, then retracted (retraction.h), then tested uneroded. The smallest erosion
/// that succeeds counts, up to a thirtieth of the object's radius. Where none succeeds (as for a shaft in its hole),
/// the object slides straight out along an axis of the world or the normal of one of its faces, as far as necessary, on
/// a motion that is proved for the eroded object. Errors: InCollision where the slide fails too, with the body and the
/// depth of the overlap; Interrupted after a stop. Deterministic.
Result<Pose> moveToClearance(const CollisionWorldPtr& world, const Pose& q, double required,
                             const StopToken& stop = {});

}  // namespace glissade
