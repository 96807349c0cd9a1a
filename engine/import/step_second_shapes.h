#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "engine/import/step_assembly.h"

namespace glissade {

struct SecondShapes {
  std::set<std::uint64_t> items;  ///< entities of the items
  StepNotes notes;                ///< one for each
};

/// Removes triangles with the size and the place of their product's boundaries: they are a second representation,
/// although the file does not state that. Runs in the importing process only.
SecondShapes takeOutSecondShapes(std::vector<StepSolid>& solids, const StandInShapes& standIns);

}  // namespace glissade
