#pragma once

#include <string>

#include "engine/study/study_report.h"

namespace glissade {

/// The page of results of a folder that packaging/benchmarks.sh filled:
///
///     collision.json, nearest_neighbours.json, octree.json, growth.json   of tests/benchmarks
///     a folder for each study
///     commands.txt   what was run
///     benchmarks.html   the page
///
/// The page depends on these files only. A missing file is named on the page. Errors: a malformed file, or a folder
/// with none of them.
Result<StudyReport> benchmarkPage(const std::string& folder, Warnings& warnings);

/// Writes FOLDER/benchmarks.html.
Outcome writeBenchmarkPage(const std::string& folder, Warnings& warnings);

}  // namespace glissade
