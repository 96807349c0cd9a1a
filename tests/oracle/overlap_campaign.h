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

/// Writes pairs of overlapping solids as STEP, lets `sequence` disassemble them, and gives `check` straight paths on
/// the blocked ways, with claims of several kinds: either body thinner, either body cut. Prints rows "name | tried |
/// clean | defects | seconds | peak MB | seed". Returns 0 if no object leaves on a blocked way, all free objects leave,
/// and the solids share a volume on blocked ways and none at the end of free ways.
int runOverlaps(const OverlapOptions& options);

}  // namespace glissade::oracle
