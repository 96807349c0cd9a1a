#pragma once

#include <cstdint>

/// Private to this room: what marks a scenario file.
namespace glissade::scenario_format {

inline constexpr const char* kName = "glissade-scenario";
inline constexpr std::uint64_t kVersion = 1;

}  // namespace glissade::scenario_format
