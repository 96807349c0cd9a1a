#pragma once

#include <optional>

#include "engine/operator/run_log.h"

namespace glissade {

/// The first difference between a replay and its record.
struct RunDifference {
  std::uint64_t same = 0;  ///< last step known to be equal; 0: none
  RunCheckpoint recorded;  ///< first checkpoint that differs
  RunCheckpoint replayed;  ///< checkpoint at the same step, or the replay's last
};

/// Compares a replay with its record, checkpoint by checkpoint. Nothing: the roadmaps are equal.
std::optional<RunDifference> firstDifference(const RunLog& recorded, const RunLog& replayed);

}  // namespace glissade
