#pragma once

#include "engine/base/enum_names.h"

namespace glissade {

/// Tools that turn fasteners, and the pliers that open retaining rings.
enum class ToolKind { None, HexKey, Socket, Screwdriver, OpenWrench, CirclipPliers };

inline constexpr EnumNames<ToolKind, 6> kToolNames{
    {"none", "hex_key", "socket", "screwdriver", "open_wrench", "circlip_pliers"}};
/// True if the tool turns a head, so that its volume is known.
inline bool turnsHead(ToolKind kind) { return kind != ToolKind::None && kind != ToolKind::CirclipPliers; }

}  // namespace glissade
