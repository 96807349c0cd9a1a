#pragma once

#include <vector>

#include "engine/base/stop_token.h"
#include "engine/scenario/part_files.h"

namespace glissade {

/// The parts with every STEP file that holds several, and does not move, as one entry a part. A part that is
/// named, or lies in an assembly that is named, by another entry or by the scenario is that one's. Names that
/// are short get their full form.
///
/// `scenarioFile` is where the scenario is saved, or empty; `read` takes what is read. Errors are those of the
/// importer, and that there is no part of a name.
Result<std::vector<PartFile>> oneEntryEach(const std::vector<PartFile>& parts, const Scenario& scenario,
                                           const std::string& scenarioFile, GeometryCache& read, const StopToken& stop);

}  // namespace glissade
