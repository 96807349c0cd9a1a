#pragma once

#include <optional>

#include "engine/base/stop_token.h"
#include "engine/scenario/scenario.h"

namespace glissade::cli {

/// What a command line says about fits, before what the scenario says.
struct FitOptions {
  std::optional<bool> on;
  std::optional<double> acceptedClash;  ///< metres; turns fits on unless they are turned off
};

/// The settings with what the options say.
FitSettings withOptions(FitSettings settings, const FitOptions& options);

/// Finds the fits again where the options change the scenario's settings, and prints warnings of the scenario and of
/// its fits.
Outcome applyOptions(const FitOptions& options, LoadedScenario& loaded, const StopToken& stop);

}  // namespace glissade::cli
