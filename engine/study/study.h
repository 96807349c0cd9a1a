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

/// A column of a paper's table, and the corresponding quantity of the study.
struct PaperColumn {
  std::string key;    ///< key in the rows' "paper"
  std::string title;  ///< heading in the report
  Quantity quantity;
};

/// A number as printed, words ("lower than G"), or nothing where the paper prints none.
using PaperValue = std::variant<std::monostate, double, std::string>;

/// Title and source of a study, for its report.
struct StudyHeading {
  std::string name;  ///< short name for files: "table-1"
  std::string title;
  std::string description;
  std::string citation;
  std::vector<PaperColumn> paper;
  std::vector<Finding> findings;  ///< findings that the report checks
};

/// Settings that are run repeatedly with different seeds.
struct StudyCell {
  std::string label;           ///< text for people: the row, and the other variable settings
  std::string row;             ///< the named row to which it belongs; empty: the study has none
  std::string scenario;        ///< path as in the study, relative to the study's folder
  std::string scenarioSha256;  ///< hash of the canonical scenario; empty until resolved
  std::string strategy;
  std::string operatorName;
  std::map<ParameterId, double> settings;    ///< parameters that the study sets
  std::map<ParameterId, double> parameters;  ///< all parameters in force; empty until resolved
  std::uint64_t memoryLimitMb = 0;           ///< limit of the run's process; 0: none
  std::vector<std::uint64_t> seeds;          ///< ascending
  std::map<std::string, PaperValue> paper;   ///< values by key of a PaperColumn, and optionally "note"
  /// Quartiles of its own results at full size, lower, median, upper, by key of a PaperColumn; empty: not stated.
  std::map<std::string, std::vector<double>> measured;
  std::string location;  ///< place in the study file, for messages
};

/// A study file as a value: all cells, in the order of the file.
struct Study {
  StudyHeading heading;
  bool quick = false;
  std::vector<StudyCell> cells;
};

}  // namespace glissade
