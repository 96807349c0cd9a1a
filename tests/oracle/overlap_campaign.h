#pragma once

#include <cstdint>
#include <string>

namespace glissade::oracle {

struct OverlapOptions {
  std::string cli;     ///< glissade-cli
  std::string folder;  ///< cases with a finding stay in it
  std::uint64_t seed = 1;
  std::uint64_t cases = 16;
};

/// Writes pairs of overlapping solids as STEP, lets `sequence` take them apart, and gives `check` straight paths on the
/// ways that are blocked, with claims of several kinds: either body thinner, either body cut. Prints rows
/// "name | tried | clean | defects | seconds | peak MB | seed". Returns 0 where no object leaves on a blocked way, all
/// free ones leave, and the solids share a volume on blocked ways and none at the end of free ones.
int runOverlaps(const OverlapOptions& options);

}  // namespace glissade::oracle
