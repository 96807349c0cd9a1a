#pragma once

#include "engine/base/json_formats.h"
#include "engine/places/body_class.h"

namespace glissade {

extern template struct ObjectFormat<BodyClass>;
/// A list of classes of bodies, as in resources/knowledge/body_classes.json.
inline constexpr ListFormat<ObjectFormat<BodyClass>> kBodyClasses{};

/// The classes of resources/knowledge/body_classes.json, which is part of the program.
std::vector<BodyClass> usualBodyClasses();

}  // namespace glissade
