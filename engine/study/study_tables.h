#pragma once

#include "engine/study/study_folder.h"
#include "engine/study/study_summary.h"

namespace glissade {

/// Writes the tables of what a folder holds (RFC 4180, numbers as C prints them, in the order of cells
/// and seeds):
///
///     runs.csv             a row a run: settings, how it ended, what it found
///     summary.csv, .json   a row a cell: success, quartiles and means, the paper's numbers
///     timing.csv           a row a run: seconds and memory on this machine
///     timing_summary.csv   a row a cell of these
///
/// The first three are the same bytes however the runs were spread over jobs, shards and machines, as
/// long as none ended at a limit of time or memory.
Outcome writeTables(const StudyFolder& folder, Warnings& warnings);

}  // namespace glissade
