#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "engine/import/step_assembly.h"

namespace glissade {

struct SecondShapes {
  std::set<std::uint64_t> items;   ///< entities
  std::vector<std::string> notes;  ///< a line of the protocol about each
};

/// Takes out triangles that are as large as the boundaries of their product and where those are: they are a second
/// representation of them, although the file does not say so. Runs in the importing process only.
SecondShapes takeOutSecondShapes(std::vector<StepSolid>& solids, const StandInShapes& standIns);

}  // namespace glissade
