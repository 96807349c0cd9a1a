#pragma once

#include <algorithm>
#include <cstddef>

#include "engine/base/thread_team.h"

namespace glissade {

/// Calls `take` for each number below `count`. Pieces of `atOnce` numbers run in several threads, if there is more than
/// one piece.
template <class Take>
void forEachInThreads(std::size_t count, std::size_t atOnce, const Take& take) {
  const auto takePiece = [&](std::size_t piece) {
    for (std::size_t i = piece * atOnce; i < std::min(count, (piece + 1) * atOnce); ++i) take(i);
  };
  const std::size_t pieces = (count + atOnce - 1) / atOnce;
  if (pieces <= 1) {
    takePiece(0);
    return;
  }
  ThreadTeam team(usableCores() - 1);
  team.run(pieces, takePiece);
}

}  // namespace glissade
