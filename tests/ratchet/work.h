#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace glissade::ratchet {

/// The work of a case, counted without a clock, so that it is equal on every machine:
/// - pairs: pairs of boxes and leaves that the collision kernel has looked at;
/// - queries: collision and distance queries of a planner;
/// - configurations: random, operator and contact configurations;
/// - allocations: blocks that the process has taken from the heap;
/// - peak_kb: largest use of the heap, kB;
/// - size: size of the result: configurations of a path, bytes of a plan, bytes that an importer returns.
inline constexpr std::array<std::string_view, 6> kMeasures{"pairs",       "queries", "configurations",
                                                           "allocations", "peak_kb", "size"};
inline constexpr std::size_t kPairs = 0, kQueries = 1, kConfigurations = 2, kAllocations = 3, kPeakKb = 4, kSize = 5;

/// Values in the order of kMeasures; nothing if the case does not have the measure.
using Work = std::array<std::optional<std::uint64_t>, kMeasures.size()>;

/// A case with its work.
struct WorkRow {
  std::string family;
  std::string name;
  std::uint64_t seed = 1;
  Work work{};
  std::string reason{};  ///< why the row has these values
};

}  // namespace glissade::ratchet
