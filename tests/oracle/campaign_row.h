#pragma once

#include <cstdint>
#include <string>

namespace glissade::oracle {

/// Prints "name | tried | clean | defects | seconds | peak MB | seed": processor seconds and largest memory of this
/// process and of its collected children.
void printRow(const std::string& name, std::uint64_t tried, std::uint64_t defects, std::uint64_t seed);

}  // namespace glissade::oracle
