#pragma once

#include <cstdint>
#include <random>
#include <string>

namespace glissade::reliability {

/// A malformed variant: one to three changes of bytes, numbers, lines or brackets, drawn by the engine. The same
/// engine gives the same variants everywhere.
std::string mutated(const std::string& good, std::mt19937_64& engine);

}  // namespace glissade::reliability
