#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/files/scenario.h"

namespace glissade {

/// Options for fits that override a scenario's settings.
struct FitOptions {
  std::optional<bool> on;
  std::optional<double> acceptedClash;  ///< metres; turns fits on unless they are turned off
  std::vector<std::string> cut{};       ///< as in FitSettings::cut
};

/// The settings, overridden by the options.
FitSettings withOptions(FitSettings settings, const FitOptions& options);

/// loadScenario with these options instead of the file's settings. Fits that are turned off are not searched for.
Result<LoadedScenario> loadScenario(const std::string& file, const FitOptions& options, const StopToken& stop = {});

}  // namespace glissade
