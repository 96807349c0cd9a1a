#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/base/parameters.h"
#include "engine/study/finding.h"

namespace glissade {

/// A column of a paper's table, and what of ours stands beside it.
struct PaperColumn {
  std::string key;    ///< in the rows' "paper"
  std::string title;  ///< as the report prints it
  Quantity quantity;
};

/// A number as printed, or words ("lower than G"), or nothing where the paper prints none.
using PaperValue = std::variant<std::monostate, double, std::string>;

/// Where a study comes from, for its report.
struct StudyHeading {
  std::string name;  ///< short, for files: "table-1"
  std::string title;
  std::string description;
  std::string citation;
  std::vector<PaperColumn> paper;
  std::vector<Finding> findings;  ///< that the report checks
};

/// Settings that are run again and again with other seeds.
struct StudyCell {
  std::string label;           ///< for people: the row, and what else varies
  std::string row;             ///< the named row it belongs to; empty: the study has none
  std::string scenario;        ///< relative to the study's folder, as the study names it
  std::string scenarioSha256;  ///< of the canonical scenario; empty until resolved
  std::string strategy;
  std::string operatorName;
  std::map<ParameterId, double> settings;    ///< what the study sets
  std::map<ParameterId, double> parameters;  ///< all that are in force; empty until resolved
  std::uint64_t memoryLimitMb = 0;           ///< of the run's process; 0 is no limit
  std::vector<std::uint64_t> seeds;          ///< ascending
  std::map<std::string, PaperValue> paper;   ///< by key of a PaperColumn, and perhaps "note"
  std::string location;                      ///< in the study file, for messages
};

/// A study file as a value: every cell spelled out, in the order of the file.
struct Study {
  StudyHeading heading;
  bool quick = false;
  std::vector<StudyCell> cells;
};

}  // namespace glissade
