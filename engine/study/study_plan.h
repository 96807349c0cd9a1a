#pragma once

#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/study/study.h"

namespace glissade {

/// A study with all data that decide its results: parameters in force, content of the scenarios, version of the
/// program. Two folders of results belong together when the texts of their plans are equal.
struct StudyPlan {
  Study study;              ///< cells resolved
  std::string studySha256;  ///< hash of the study file
  std::string version;      ///< version of Glissade
};

/// Loads each scenario once and checks each cell's parameters against it.
Result<StudyPlan> planStudy(const std::string& studyFile, bool quick, Warnings& warnings);

/// Canonical JSON, written and read (`file` is for messages).
std::string writePlan(const StudyPlan& plan);
Result<StudyPlan> readPlan(const std::string& text, const std::string& file);

/// One run of a study.
struct StudyRun {
  std::size_t cell = 0;  ///< index into the study's cells
  std::uint64_t seed = 0;

  friend bool operator<(const StudyRun& a, const StudyRun& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.seed < b.seed;
  }
};

/// Every N-th run, counted through cells and seeds: shard 1 of 1 is all of them.
struct Shard {
  std::size_t index = 1;  ///< from 1 to count
  std::size_t count = 1;
};

/// The runs of a shard. The first seeds of all cells come first, so that an interrupted study has run all cells.
std::vector<StudyRun> runsOf(const Study& study, const Shard& shard);

/// The scenario of a cell, for a study that was read from `studyFile`.
std::string scenarioFileOf(const std::string& studyFile, const StudyCell& cell);

/// Prefix of strategies that find an assembly sequence instead of a path, followed by a strategy of assembly plans.
inline constexpr std::string_view kSequencePrefix = "sequence-";
bool isSequence(const StudyCell& cell);

/// Arguments of the glissade-cli for the run.
std::vector<std::string> planArguments(const StudyCell& cell, std::uint64_t seed, const std::string& scenarioFile);

}  // namespace glissade
