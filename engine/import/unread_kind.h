#pragma once

#include <optional>
#include <string>

#include "engine/base/diagnostic.h"

namespace glissade {

/// An error of MalformedInput for a file with the ending of a kind that is known and not read (SolidWorks, JT,
/// Parasolid, 3MF …): it names the kind and the format to export. Nothing for other endings. The content is not looked
/// at.
std::optional<Diagnostic> unreadKind(const std::string& file);

}  // namespace glissade
