#include "app/cli/fit_options.h"

#include "app/cli/report.h"
#include "engine/scenario/scenario_fits.h"

namespace glissade::cli {

FitSettings withOptions(FitSettings settings, const FitOptions& options) {
  if (options.acceptedClash) {
    settings.acceptedClash = *options.acceptedClash;
    settings.on = true;
  }
  if (options.on) settings.on = *options.on;
  return settings;
}

Outcome applyOptions(const FitOptions& options, LoadedScenario& loaded, const StopToken& stop) {
  if (options.on || options.acceptedClash) {
    loaded.scenario.fits = withOptions(loaded.scenario.fits, options);
    if (const Outcome fitted = applyFits(loaded, stop); !fitted) return fitted.error();
  }
  reportWarnings(loaded.warnings);
  reportWarnings(loaded.fits.warnings);
  return Done{};
}

}  // namespace glissade::cli
