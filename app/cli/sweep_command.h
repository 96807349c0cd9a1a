#pragma once

#include <optional>
#include <string>

#include "app/cli/report.h"

namespace glissade::cli {

struct SweepOptions {
  std::string scenario;
  std::string path;
  std::string output;
  std::optional<double> bound;  ///< metres
  Format format = Format::Text;
};

/// glissade-cli sweep: what the object covers along a path, as STL or GLB. Exit code 0 written.
int runSweep(const SweepOptions& options);

}  // namespace glissade::cli
