#pragma once

#include <string>

#include "app/cli/report.h"

namespace glissade::cli {

struct ReplayOptions {
  std::string record;
  std::string scenario;  ///< empty: the one that the record names
  Format format = Format::Text;
};

/// glissade-cli replay: runs a recorded run again and compares the roadmaps bit by bit. Exit code 0
/// the same, 1 different; records of version 1 hold no fingerprints, there the nodes are counted.
int runReplay(const ReplayOptions& options);

}  // namespace glissade::cli
