#pragma once

#include "engine/places/free_space.h"

namespace glissade {

/// A doorway: where the free section, swept along an axis, is much smaller than on both sides.
struct Passage {
  int axis = 0;
  std::vector<std::size_t> cells;  ///< ascending
  double contraction = 1.0;        ///< smaller of the sections on both sides / narrowest section
};

/// Finds the doorways of the free space by slice decomposition (Morse decomposition along each axis;
/// Choset 2000): chains of connected slice components that shrink and widen again by at least half.
/// The axis with the sharpest contraction goes first; its doorways are closed and the rest is looked
/// at again, so that a hole does not make one room of the two that it joins. Unfinished after a stop.
std::vector<Passage> findPassages(const FreeSpace& space, const StopToken& stop = {});

}  // namespace glissade
