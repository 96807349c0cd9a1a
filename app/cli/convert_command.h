#pragma once

#include <string>

#include "app/cli/report.h"

namespace glissade::cli {

struct ConvertOptions {
  std::string input;
  std::string output;
  std::string scenario;  ///< for path formats that hold clearances
  Format format = Format::Text;
};

/// glissade-cli convert: an OMPL.app .cfg to a scenario, or a path to another path format.
int runConvert(const ConvertOptions& options);

}  // namespace glissade::cli
