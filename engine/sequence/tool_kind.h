#pragma once

#include <optional>
#include <string>
#include <vector>

namespace glissade {

/// Tools that turn fasteners.
enum class ToolKind { None, HexKey, Socket, Screwdriver, OpenWrench };

/// "hex_key", "socket", "screwdriver", "open_wrench" or "none".
const char* toolName(ToolKind kind);
std::optional<ToolKind> toolByName(const std::string& name);

}  // namespace glissade
