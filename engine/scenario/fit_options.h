#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// What is asked of the fits besides what a scenario says.
struct FitOptions {
  std::optional<bool> on;
  std::optional<double> acceptedClash;  ///< metres; turns fits on unless they are turned off
  std::vector<std::string> cut{};       ///< as FitSettings::cut
};

/// The settings with what the options say.
FitSettings withOptions(FitSettings settings, const FitOptions& options);

/// loadScenario with these options in place of what the file says. Fits that are turned off are not looked for.
Result<LoadedScenario> loadScenario(const std::string& file, const FitOptions& options, const StopToken& stop = {});

}  // namespace glissade
