#pragma once

#include <cstdint>
#include <string>

#include "app/cli/report.h"

namespace glissade::cli {

/// Shortcuts tried where nobody says how many.
inline constexpr int kSmoothingAttempts = 300;

struct SmoothOptions {
  std::string scenario;
  std::string input;
  std::string output;  ///< .csv, .json or .path
  int attempts = kSmoothingAttempts;
  std::uint64_t seed = 1;
  Format format = Format::Text;
};

/// glissade-cli smooth: shortens a path and keeps it certified. Exit code 0 written, 1 the path itself
/// is not certified.
int runSmooth(const SmoothOptions& options);

}  // namespace glissade::cli
