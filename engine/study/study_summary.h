#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/study/statistics.h"
#include "engine/study/study_folder.h"

namespace glissade {

/// A number over the runs that were solved, and over all that have it.
struct MeasureSummary {
  std::string name;
  Distribution solved;
  Distribution all;
};

/// One cell of a study, summed up.
struct CellSummary {
  std::size_t planned = 0;
  std::size_t runs = 0;  ///< that have ended, whatever way
  std::array<std::size_t, kRunStatusCount> statuses{};
  Proportion success;                    ///< of the runs
  std::vector<MeasureSummary> measures;  ///< resultColumns() that are summarised
  std::vector<MeasureSummary> timing;    ///< planning_s, planning_cpu_s, wall_s, cpu_s, peak_memory_mb

  std::size_t solved() const { return statuses[static_cast<std::size_t>(RunStatus::Solved)]; }
};

/// In the order of the study's cells.
std::vector<CellSummary> summarise(const Study& study, const StudyResults& results);

}  // namespace glissade
