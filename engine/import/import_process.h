#pragma once

#include <string>
#include <string_view>

#include "engine/base/result.h"

namespace glissade {

/// Name of the importing program, found beside the running one.
inline constexpr std::string_view kImportProgram = "glissade-import";
/// Seconds that one import may take.
inline constexpr unsigned kImportSeconds = 5;

/// Runs the importing program on the content and returns what it wrote, unchecked; empty where it
/// crashed or ran out of memory. MalformedInput (without a file) when it took more than
/// kImportSeconds; Internal when it cannot be started. Blocks; any thread.
Result<std::string> runImportProcess(std::string_view content, const std::string& ending);

}  // namespace glissade
