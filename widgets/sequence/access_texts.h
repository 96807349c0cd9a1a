#pragma once

#include <QString>

#include <vector>

#include "engine/access/motion_access.h"

namespace glissade {

// Texts about the access of a hand, in the user's language.

/// The short text about a step in a table: "reached", "no hand", "not seen".
QString accessMark(const MotionAccess& motion);
/// "The hand is blocked by plate, 11 % of the way from the place; 81 % of the place is seen". `bodies`: the bodies that
/// the answer refers to.
QString accessText(const MotionAccess& motion, const std::vector<RigidBody>& bodies);
/// Name of a size, such as "5th percentile of women".
QString handSizeText(HandSize size);

}  // namespace glissade
