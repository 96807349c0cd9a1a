#pragma once

#include "engine/base/enum_names.h"

namespace glissade {

enum class FastenerKind { None, Screw, Nut, Washer, Pin };

inline constexpr EnumNames<FastenerKind, 5> kFastenerNames{{"none", "screw", "nut", "washer", "pin"}};

}  // namespace glissade
