#pragma once

#include "engine/base/enum_names.h"

namespace glissade {

/// Tools that turn fasteners.
enum class ToolKind { None, HexKey, Socket, Screwdriver, OpenWrench };

inline constexpr EnumNames<ToolKind, 5> kToolNames{{"none", "hex_key", "socket", "screwdriver", "open_wrench"}};

}  // namespace glissade
