#pragma once

#include "engine/access/hand_posture.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// Palm, fingers and thumb in the hand's frame: closed surfaces that overlap.
TriangleMesh handShape(const HandMeasures& hand, const HandPosture& posture);

/// The forearm from the wrist to the elbow, in its frame: the wrist is at the origin and the elbow along -z.
TriangleMesh forearmShape(const HandMeasures& hand);

}  // namespace glissade
