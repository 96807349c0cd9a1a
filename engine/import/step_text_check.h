#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace glissade {

/// Why OpenCASCADE must not see a STEP text (ISO 10303-21), with the line; nothing where it may. Refused
/// is what makes it compute without end or overflow its stack:
/// - a number that is longer than 350 characters or not finite, and words such as nan in place of one;
/// - parentheses nested more than 100 deep, or without their other half;
/// - a list of more than 100,000 values, but of tessellations: OpenCASCADE's time grows with the square of their
///   number, and it is not given those;
/// - entities that are there twice, that refer to one that is not there, or to each other in a circle
///   (step_references.h): OpenCASCADE leaves out what should have been there.
/// Takes n log n of time. Other mistakes of syntax are not looked for.
std::optional<std::string> faultOfStepText(std::string_view text);

}  // namespace glissade
