#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/study/statistics.h"
#include "engine/study/study_folder.h"

namespace glissade {

/// Statistics of a number over the solved runs, and over all runs that have it.
struct MeasureSummary {
  std::string name;
  Distribution solved;
  Distribution all;
};

/// Summary of one cell of a study.
struct CellSummary {
  std::size_t planned = 0;
  std::size_t runs = 0;  ///< number of runs that have ended
  std::array<std::size_t, kRunStatusCount> statuses{};
  Proportion success;                    ///< share of solved runs
  std::vector<MeasureSummary> measures;  ///< one entry for each summarised column of resultColumns()
  /// One entry for each of planning_s, planning_cpu_s, wall_s, cpu_s, peak_memory_mb.
  std::vector<MeasureSummary> timing;

  std::size_t solved() const { return statuses[static_cast<std::size_t>(RunStatus::Solved)]; }
};

/// One summary for each cell, in the order of the study.
std::vector<CellSummary> summarise(const Study& study, const StudyResults& results);

}  // namespace glissade
