#pragma once

#include <optional>

#include "engine/operator/run_log.h"

namespace glissade {

/// Where a replay first was not what the record says.
struct RunDifference {
  std::uint64_t same = 0;  ///< the last step known to be the same; 0: none
  RunCheckpoint recorded;  ///< the first that differs
  RunCheckpoint replayed;  ///< at the same step, or the replay's last
};

/// Compares a replay with what was recorded, checkpoint by checkpoint. Nothing: the same roadmap.
std::optional<RunDifference> firstDifference(const RunLog& recorded, const RunLog& replayed);

}  // namespace glissade
