#pragma once

#include <optional>
#include <string>

#include "engine/base/diagnostic.h"

namespace glissade {

/// An error of MalformedInput for a file with the ending of a known kind that is not read (SolidWorks, JT, Parasolid,
/// 3MF …): it names the kind and the format to export. Nothing for other endings. The content is not examined.
std::optional<Diagnostic> unreadKind(const std::string& file);

}  // namespace glissade
