#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/files/part_files.h"

namespace glissade {

/// The guessed unit of files that do not state it.
struct UnitGuess {
  double unit = 0.001;   ///< metres per unit: millimetres or metres
  bool inDoubt = false;  ///< both units fit, or none does
};

/// Guesses the unit from the bounding boxes of the parts in the numbers of their files, which have one unit. A unit
/// fits if the diagonal of the smallest part is at least 0.5 mm and the diagonal of all together at most 50 m.
/// Millimetres are chosen if they fit, and are not in doubt from 20 units on.
UnitGuess guessUnit(const std::vector<Box3>& inFile);

/// Sets the guessed unit for the parts whose files state none. `read` as in partsInFile(). Returns warnings about the
/// guess, where it is in doubt or not millimetres. Errors are those of the importers.
Result<Warnings> guessUnits(std::vector<PartFile>& parts, GeometryCache& read, const StopToken& stop = {});

}  // namespace glissade
