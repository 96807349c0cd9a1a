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
/// A function of these files alone. What is not there is said to be missing; a file that cannot be
/// understood, or a folder with none of them, is the error.
Result<StudyReport> benchmarkPage(const std::string& folder, Warnings& warnings);

/// Writes FOLDER/benchmarks.html.
Outcome writeBenchmarkPage(const std::string& folder, Warnings& warnings);

}  // namespace glissade
