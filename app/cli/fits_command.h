#pragma once

#include <string>

#include "app/cli/report.h"
#include "engine/product/contact_report.h"
#include "engine/scenario/fit_options.h"

namespace glissade::cli {

struct FitsOptions {
  std::string file;  ///< a scenario, or a part file as usualPart() takes it
  ContactLimits limits;
  FitOptions fits{};
  std::vector<std::string> without{};  ///< bodies and assemblies that are left out
  std::vector<std::string> open{};     ///< parts of several solids that are taken as their solids
  double deflection = 0.0;             ///< metres, of STEP files; 0: by the size of each part
  bool csv = false;
  Format format = Format::Text;
};

/// glissade-cli fits: contacts, fits and clashes of a product or scenario.
int runFits(const FitsOptions& options);

}  // namespace glissade::cli
