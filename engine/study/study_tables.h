#pragma once

#include "engine/study/study_folder.h"
#include "engine/study/study_summary.h"

namespace glissade {

/// Writes the tables of a folder of results into `out` (RFC 4180, numbers as C prints them, in the order of cells and
/// seeds):
///
///     runs.csv             one row per run: settings, end and result
///     summary.csv, .json   one row per cell: success, quartiles and means, the paper's numbers
///     timing.csv           one row per run: seconds and memory on this machine
///     timing_summary.csv   one row per cell: statistics of timing.csv
///
/// The first three do not depend on the distribution of the runs over jobs, shards and machines, byte by byte, unless a
/// run ended at a limit of time or memory.
Outcome writeTables(const StudyFolder& folder, const std::string& out, Warnings& warnings);

}  // namespace glissade
