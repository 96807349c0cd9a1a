#pragma once

#include <optional>
#include <string>

#include "app/cli/report.h"
#include "engine/scenario/fit_options.h"

namespace glissade::cli {

struct CheckOptions {
  std::string scenario;
  std::string path;
  std::optional<double> requiredClearance;  ///< metres; the scenario's where absent
  FitOptions fits;
  bool edges = false;  ///< certificates of every edge
  Format format = Format::Text;
};

/// glissade-cli check: an independent certificate of any path. Exit code 0 valid, 1 invalid.
int runCheck(const CheckOptions& options);

}  // namespace glissade::cli
