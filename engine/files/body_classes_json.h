#pragma once

#include "engine/base/json_reader.h"
#include "engine/places/body_class.h"

namespace glissade {

/// A list of classes of bodies, as in resources/knowledge/body_classes.json. Throws JsonError.
std::vector<BodyClass> readBodyClasses(const JsonCursor& at);
JsonCursor::Json toJson(const BodyClass& bodyClass);

/// The classes of resources/knowledge/body_classes.json, which is part of the program.
std::vector<BodyClass> usualBodyClasses();

}  // namespace glissade
