#pragma once

namespace glissade::evidence {}

namespace glissade::check {

// The judge uses the names of the measurements without a prefix.
using namespace evidence;

}  // namespace glissade::check
