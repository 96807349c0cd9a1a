#pragma once

#include <string>
#include <vector>

#include "app/cli/report.h"
#include "engine/access/hand_measures.h"

namespace glissade::cli {

struct AccessOptions {
  std::string file;
  std::string path;  ///< of the scenario's object, or empty
  std::string plan;  ///< of the product, or empty
  HandSize hand = HandSize::Average;
  std::vector<double> eye;  ///< three numbers, metres; empty: positions are tried
  Format format = Format::Text;
};

/// glissade-cli access: whether a hand gets to a path, or to the steps of a plan. Exit codes: 0 it gets to all of them
/// and sees them, 1 not to all, and those of wrong usage and input.
int runAccess(const AccessOptions& options);

}  // namespace glissade::cli
