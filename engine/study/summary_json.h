#pragma once

#include <string>
#include <vector>

#include "engine/study/study_summary.h"

namespace glissade {

/// summary.json: the study's heading, and for each cell its settings, its summary, the paper's numbers
/// and the command that repeats it. Nothing in it depends on the machine's speed.
std::string summaryJson(const StudyFolder& folder, const std::vector<CellSummary>& summaries);

}  // namespace glissade
