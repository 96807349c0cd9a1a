#pragma once

#include <string>
#include <vector>

#include "engine/study/study.h"
#include "engine/study/study_summary.h"
#include "engine/study/study_words.h"

namespace glissade {

enum class Verdict {
  Holds,
  Refuted,
  Open  ///< no pair refutes it, but some cannot be compared: not run, or never solved
};
const char* name(Verdict verdict);  ///< "holds", "does not hold", "open"

/// What a study's results say of a finding.
struct CheckedFinding {
  Verdict verdict = Verdict::Open;
  std::size_t compared = 0;  ///< pairs
  std::size_t agreeing = 0;  ///< of these
  std::string numbers;       ///< the pair that speaks most against it, or why there is none
};

CheckedFinding checkFinding(const Finding& finding, const Study& study, const std::vector<CellSummary>& summaries,
                            const StudyWords& words = {});

}  // namespace glissade
