#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/study/study.h"

namespace glissade {

/// The settings that a study varies, before its cells are listed.
struct StudyAxes {
  std::vector<std::string> scenarios;
  std::vector<std::string> strategies;
  std::vector<std::string> operators{"none"};
  std::map<ParameterId, double> settings;
  std::vector<std::pair<ParameterId, std::vector<double>>> grid;
  std::uint64_t memoryLimitMb = 0;
  std::vector<std::uint64_t> seeds;
};

/// A named row. Its settings replace or extend those of the whole study.
struct StudyRow {
  std::string label;
  StudyAxes axes;  ///< axes with the row's own settings applied
  std::map<std::string, PaperValue> paper;
  std::string location;
};

/// Makes the cells of a row: scenarios x strategies x operators x grid, the last varying fastest. Labels name the row
/// and all settings with more than one value. cellCount() is the size of this product, which may be too large to be
/// listed.
double cellCount(const StudyRow& row);
std::vector<StudyCell> cellsOf(const StudyRow& row);

/// A short name of a scenario that distinguishes it: "environment-1" of "../environment-1/scenario.json", or
/// "tight-star".
std::string scenarioName(const std::string& scenario);

/// True for limits of a run, which are parameters but are not varied in a study.
bool isLimit(ParameterId id);

/// Appends a part to a text, separated by a comma.
void appendPart(std::string& text, const std::string& part);

}  // namespace glissade
