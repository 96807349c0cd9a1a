#pragma once

#include <optional>
#include <string_view>

#include "engine/base/message.h"

namespace glissade {

/// The reason, with the line, why OpenCASCADE must not read a STEP text (ISO 10303-21); nothing if it may. Refused are
/// texts that make it compute without end or overflow its stack:
/// - a number that is longer than 350 characters or not finite, and words such as nan in place of one;
/// - parentheses nested more than 100 deep, or unbalanced;
/// - a list of more than 100,000 values, except in tessellations: OpenCASCADE's time grows with the square of their
/// number, and it does not get tessellations;
/// - entities that exist twice, that refer to a missing entity, or to each other in a circle (step_references.h):
/// OpenCASCADE would silently leave out objects.
/// Takes O(n log n) time. Other syntax errors are not searched.
std::optional<Message> faultOfStepText(std::string_view text);

}  // namespace glissade
