#pragma once

#include <cstdint>
#include <string>

#include "app/cli/report.h"
#include "engine/planning/smoothing/shortcuts.h"

namespace glissade::cli {

struct SmoothOptions {
  std::string scenario;
  std::string input;
  std::string output;  ///< format by its ending
  int attempts = kUsualShortcuts;
  std::uint64_t seed = 1;
  Format format = Format::Text;
};

/// glissade-cli smooth: shortens a path and keeps it certified. Exit code 0 written, 1 the path itself
/// is not certified.
int runSmooth(const SmoothOptions& options);

}  // namespace glissade::cli
