#include <glissade/functions.h>
#include <glissade/version.h>

#include "engine/import/importer_process.h"

namespace glissade::api {

const char* libraryVersion() { return kVersion; }

std::string programFile(const std::string& name) { return glissade::programFile(name); }

}  // namespace glissade::api
