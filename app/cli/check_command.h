#pragma once

#include <string>

#include "app/cli/report.h"

namespace glissade::cli {

struct CheckOptions {
  std::string scenario;
  std::string path;
  double requiredClearance = 0.0;  ///< metres; 0: the scenario's
  Format format = Format::Text;
};

/// glissade-cli check: an independent certificate of any path. Exit code 0 valid, 1 invalid.
int runCheck(const CheckOptions& options);

}  // namespace glissade::cli
