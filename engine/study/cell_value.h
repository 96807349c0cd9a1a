#pragma once

#include <optional>
#include <string>

#include "engine/study/study.h"
#include "engine/study/study_summary.h"
#include "engine/study/study_words.h"

namespace glissade {

/// A value of a cell with its spread: Wilson's 95 % interval of a success rate, else the quartiles.
struct CellValue {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
  std::size_t count = 0;  ///< number of runs
};

/// The value of a quantity. Nothing where no run has it: none was solved, or the strategy does not have the measure.
std::optional<CellValue> valueOf(const CellSummary& summary, const Quantity& quantity);

/// The paper's text for a cell in one of its columns; empty where there is none.
std::string paperText(const StudyCell& cell, const PaperColumn& column);

/// A description such as "median of nodes over the solved runs" or "success rate".
std::string describe(const Quantity& quantity, const StudyWords& words = {});

/// A number for people with at least three significant digits and separated thousands: "27 600", "0.152", "14.5".
std::string shortNumber(double value);
/// A share as a percentage such as "97 %".
std::string percent(double share);

}  // namespace glissade
