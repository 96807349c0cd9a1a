#pragma once

#include "engine/operator/operator_input.h"

namespace glissade {

class CameraController;

/// Moves the camera by a deflection for dt seconds, as if the scene were in the hand: a deflection to the right moves
/// the scene to the right, one towards the person brings it nearer, one about the line of sight rolls it. Without
/// `roll` the horizon stays level. `factors` scale the pace at full deflection.
void steerCamera(CameraController& camera, const Deflection& deflection, const OperatorSpeed& factors, double dt,
                 bool roll);

}  // namespace glissade
