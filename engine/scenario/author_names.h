#pragma once

#include "engine/base/enum_names.h"
#include "engine/planning/roadmap.h"

namespace glissade {

/// Authors as path files name them.
inline constexpr EnumNames<Author, 3> kAuthorNames{{"computer", "operator", "contact"}};

}  // namespace glissade
