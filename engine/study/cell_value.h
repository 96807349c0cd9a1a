#pragma once

#include <optional>
#include <string>

#include "engine/study/study.h"
#include "engine/study/study_summary.h"
#include "engine/study/study_words.h"

namespace glissade {

/// A number of a cell with its spread: Wilson's 95 % interval of a success rate, else the quartiles.
struct CellValue {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
  std::size_t count = 0;  ///< runs behind it
};

/// Nothing where no run has it: none was solved, or the measure is not of this strategy.
std::optional<CellValue> valueOf(const CellSummary& summary, const Quantity& quantity);

/// What the paper prints of a cell in one of its columns; empty where nothing.
std::string paperText(const StudyCell& cell, const PaperColumn& column);

/// "median of nodes over the solved runs", "success rate".
std::string describe(const Quantity& quantity, const StudyWords& words = {});

/// For people: three significant digits at least, thousands apart: "27 600", "0.152", "14.5".
std::string shortNumber(double value);
/// "97 %".
std::string percent(double share);

}  // namespace glissade
