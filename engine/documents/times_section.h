#pragma once

#include <string>

#include "engine/documents/document_words.h"
#include "engine/documents/plan_timing.h"
#include "engine/documents/report.h"

namespace glissade {

/// A time as text: "12.3 s".
std::string secondsText(double seconds, const DocumentWords& words);

/// Adds the duration of the work, the longest chain, and, where there is a line, its stations with a bar for each.
void addTimesSection(const PlanTiming& timing, const DocumentWords& words, Report& report);

}  // namespace glissade
