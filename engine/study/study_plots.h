#pragma once

#include <vector>

#include "engine/study/plot.h"
#include "engine/study/study.h"
#include "engine/study/study_summary.h"
#include "engine/study/study_words.h"

namespace glissade {

/// The plots of a study: for each quantity of its paper's columns (else success, virtual seconds, nodes and random
/// configurations), and the success rate, over each parameter that its cells vary. Where they vary none, the plots are
/// bars over scenarios. The series are strategies and operators, and the paper's numbers.
std::vector<Plot> plotsOf(const Study& study, const std::vector<CellSummary>& summaries, const StudyWords& words = {});

}  // namespace glissade
