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
  Open  ///< no pair refutes it, but some cannot be compared because they were not run or never solved
};
const char* name(Verdict verdict);  ///< The text "holds", "does not hold" or "open".

/// The result of checking a finding.
struct CheckedFinding {
  Verdict verdict = Verdict::Open;
  std::size_t compared = 0;  ///< number of pairs
  std::size_t agreeing = 0;  ///< number of pairs that agree
  std::string numbers;       ///< the pair with the strongest evidence against it, or the reason why there is none
};

CheckedFinding checkFinding(const Finding& finding, const Study& study, const std::vector<CellSummary>& summaries,
                            const StudyWords& words = {});

}  // namespace glissade
