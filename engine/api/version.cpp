#include <glissade/functions.h>
#include <glissade/version.h>

namespace glissade::api {

const char* libraryVersion() { return kVersion; }

}  // namespace glissade::api
