#pragma once

#include <functional>
#include <optional>

#include "widgets/workbench/script.h"

namespace glissade {

/// The failure of an event handler or of background work since the last call; nothing if all succeeded.
using TakeFailure = std::function<std::optional<Diagnostic>()>;

/// Carries out the commands of a script one by one and lets the window react between them. The first error or failure
/// ends the script and is returned, with file and line.
std::optional<Diagnostic> runScript(const std::vector<ScriptLine>& lines, const std::string& file,
                                    const ScriptCommands& commands, const TakeFailure& takeFailure);

}  // namespace glissade
