#pragma once

#include <string>
#include <vector>

namespace glissade::test {

/// The texts that the expressions of a C++ source make of string literals: `"line " + std::to_string(n) + ": " + why`
/// is "line %1: %2". Streams (`<<`) count as `+`. Literals with an encoding or raw ones are left out.
std::vector<std::string> textsMadeIn(const std::string& source);

}  // namespace glissade::test
