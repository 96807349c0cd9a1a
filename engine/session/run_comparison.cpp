#include "engine/session/run_comparison.h"

#include <algorithm>

namespace glissade {
namespace {

/// The replay's checkpoint at that step, or its last.
RunCheckpoint reached(const RunLog& replayed, std::uint64_t step) {
  const auto found =
      std::lower_bound(replayed.checkpoints.begin(), replayed.checkpoints.end(), step,
                       [](const RunCheckpoint& checkpoint, std::uint64_t at) { return checkpoint.step < at; });
  if (found != replayed.checkpoints.end() && found->step == step) return *found;
  return replayed.end.value_or(RunCheckpoint{});
}

bool same(const RunCheckpoint& recorded, const RunCheckpoint& replayed) {
  if (recorded.step == 0) return recorded.nodes == replayed.nodes;  // the record is of version 1
  return recorded.step == replayed.step && recorded.hash == replayed.hash;
}

}  // namespace

std::optional<RunDifference> firstDifference(const RunLog& recorded, const RunLog& replayed) {
  RunDifference difference;
  std::vector<RunCheckpoint> checkpoints = recorded.checkpoints;
  if (recorded.end) checkpoints.push_back(*recorded.end);
  for (const RunCheckpoint& checkpoint : checkpoints) {
    difference.recorded = checkpoint;
    difference.replayed = reached(replayed, checkpoint.step);
    if (!same(difference.recorded, difference.replayed)) return difference;
    difference.same = checkpoint.step;
  }
  return std::nullopt;
}

}  // namespace glissade
