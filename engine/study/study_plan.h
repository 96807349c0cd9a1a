#pragma once

#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/study/study.h"

namespace glissade {

/// A study with everything looked up that decides its results: parameters in force, content of the
/// scenarios, version of the program. Two folders of results belong together when their plans are the
/// same text.
struct StudyPlan {
  Study study;              ///< cells resolved
  std::string studySha256;  ///< of the study file
  std::string version;      ///< of Glissade
};

/// Loads each scenario once and checks each cell's parameters against it.
Result<StudyPlan> planStudy(const std::string& studyFile, bool quick, Warnings& warnings);

/// Canonical JSON, and back (`file` is for messages).
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
  std::size_t index = 1;  ///< 1 to count
  std::size_t count = 1;
};

/// The runs of a shard, first seed of every cell first: an interrupted study has seen all its cells.
std::vector<StudyRun> runsOf(const Study& study, const Shard& shard);

/// The scenario of a cell, for a study that was read from `studyFile`.
std::string scenarioFileOf(const std::string& studyFile, const StudyCell& cell);

/// Runs whose strategy is kSequencePrefix and one of assembly plans find a sequence, not a path.
inline constexpr std::string_view kSequencePrefix = "sequence-";
bool isSequence(const StudyCell& cell);

/// Arguments of the glissade-cli that carries the run out.
std::vector<std::string> planArguments(const StudyCell& cell, std::uint64_t seed, const std::string& scenarioFile);

}  // namespace glissade
