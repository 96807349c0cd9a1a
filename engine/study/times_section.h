#pragma once

#include <string>

#include "engine/study/plan_timing.h"
#include "engine/study/report.h"
#include "engine/study/study_words.h"

namespace glissade {

/// A time as text: "12.3 s".
std::string secondsText(double seconds, const StudyWords& words);

/// Adds the duration of the work, the longest chain, and, where there is a line, its stations with a bar for each.
void addTimesSection(const PlanTiming& timing, const StudyWords& words, Report& report);

}  // namespace glissade
