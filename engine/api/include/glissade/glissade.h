/// @file
/// All public names of Glissade. They are in the namespace glissade::api, because the engine has values of the same
/// names; this header makes them visible in glissade, so that programs write glissade::plan().
#pragma once

#include <glissade/functions.h>
#include <glissade/layers.h>
#include <glissade/session.h>
#include <glissade/version.h>

namespace glissade {
using namespace api;
}
