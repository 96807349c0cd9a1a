#pragma once

#include "engine/base/enum_names.h"

namespace glissade {

/// The feature of a fastener by which a tool turns it.
enum class DriveKind { None, HexOutside, HexSocket, Cross, Slot, SixLobe };

inline constexpr EnumNames<DriveKind, 6> kDriveNames{{"none", "hex", "hex_socket", "cross", "slot", "six_lobe"}};

}  // namespace glissade
