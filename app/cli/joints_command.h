#pragma once

#include <string>
#include <vector>

#include "app/cli/report.h"

namespace glissade::cli {

struct JointsOptions {
  std::string file;  ///< a scenario, or a part file as usualPart() takes it
  std::vector<std::string> without{};
  std::vector<std::string> open{};  ///< parts of several solids that are taken as their solids
  double deflection = 0.0;          ///< metres, of STEP files; 0: by the size of each part
  bool confirmsSuggested = false;   ///< what is suggested counts, as if a person had confirmed each of them
  Format format = Format::Text;
};

/// glissade-cli joints: how the bodies of a product or scenario are joined, with what a scenario says of it.
int runJoints(const JointsOptions& options);

}  // namespace glissade::cli
