#pragma once

#include <QString>

#include <vector>

#include "engine/access/motion_access.h"

namespace glissade {

// Texts about the access of a hand, in the user's language.

/// What a table says of a step: "reached", "no hand", "not seen".
QString accessMark(const MotionAccess& motion);
/// "The hand is blocked by plate, 11 % of the way from the place; 81 % of the place is seen". The bodies are those of
/// the answer.
QString accessText(const MotionAccess& motion, const std::vector<RigidBody>& bodies);
/// "5th percentile of women".
QString handSizeText(HandSize size);

}  // namespace glissade
