#pragma once

#include <cstdint>
#include <string>

namespace glissade::oracle {

struct TrappedOptions {
  std::string cli;     ///< glissade-cli
  std::string folder;  ///< pairs with a finding stay in it
  std::uint64_t seed = 1;
  std::uint64_t pairs = 40;
  std::uint64_t planEvery = 10;  ///< the automatic planner tries one of so many pairs
  /// Both bodies lose up to three faces, near the fit or far from it; the remaining part of a lip still stops the other
  /// body. Only mesh files are written. Free bodies may then be refused.
  bool open = false;
};

/// Writes pairs as STEP, STL, OBJ and GLB. Gives `check` straight paths through the lip, with allowances of several
/// sizes, and lets the planner try. Prints rows "name | tried | clean | defects | seconds | peak MB | seed". Returns 0
/// if no trapped body leaves and all free bodies do.
int runTrapped(const TrappedOptions& options);

}  // namespace glissade::oracle
