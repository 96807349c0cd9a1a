#pragma once

#include <optional>
#include <string>

namespace glissade {

enum class FastenerKind { None, Screw, Nut, Washer, Pin };

/// "screw", "nut", "washer", "pin" or "none".
const char* fastenerName(FastenerKind kind);
std::optional<FastenerKind> fastenerByName(const std::string& name);

}  // namespace glissade
