#pragma once

#include <optional>
#include <string>

#include "engine/base/diagnostic.h"

namespace glissade {

/// What a file is that has the ending of a kind that is known and not read (SolidWorks, JT, Parasolid, 3MF …), and what
/// to export there; nothing for other endings. The content is not looked at. The error is MalformedInput.
std::optional<Diagnostic> unreadKind(const std::string& file);

}  // namespace glissade
