#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/scenario/part_files.h"

namespace glissade {

/// What a unit of files is that do not say it.
struct UnitGuess {
  double unit = 0.001;   ///< metres: millimetres or metres
  bool inDoubt = false;  ///< the other one fits as well, or none does
};

/// From the bounding boxes of the parts in the numbers of their files, which have one unit. A unit fits where the
/// smallest part is 0.5 mm or larger and all together are 50 m or smaller, each along its diagonal; what is 20 units or
/// larger is in millimetres where these fit.
UnitGuess guessUnit(const std::vector<Box3>& inFile);

/// Gives the parts whose files say no unit the one that is guessed from all of them. `read` as of partsInFile().
/// Returns what a person has to know: the guess, where it is not certain or not millimetres.
/// Errors are those of the importers.
Result<Warnings> guessUnits(std::vector<PartFile>& parts, GeometryCache& read, const StopToken& stop = {});

}  // namespace glissade
