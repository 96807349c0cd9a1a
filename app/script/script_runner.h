#pragma once

#include <functional>
#include <optional>

#include "app/script/script.h"

namespace glissade {

/// What failed in an event handler or in the background since the last call; nothing where all went well.
using TakeFailure = std::function<std::optional<Diagnostic>()>;

/// Carries out a script command by command, and lets the window react in between. The first error or failure ends it
/// and is returned, with file and line.
std::optional<Diagnostic> runScript(const std::vector<ScriptLine>& lines, const std::string& file,
                                    const ScriptCommands& commands, const TakeFailure& takeFailure);

}  // namespace glissade
