#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/study/study.h"

namespace glissade {

/// Seeds from `first` on.
struct SeedRange {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
};
/// Ascending seeds.
using StudySeeds = std::variant<std::vector<std::uint64_t>, SeedRange>;
std::uint64_t seedCount(const StudySeeds& seeds);

/// Values of parameters.
using StudyGrid = std::vector<std::pair<ParameterId, std::vector<double>>>;

/// Limits of runs.
struct StudyLimits {
  std::map<ParameterId, double> settings;  ///< those that are parameters: isLimit()
  std::optional<std::uint64_t> memoryMb;   ///< of the process of a run; 0: none
};

/// The settings that a study, a row or the quick section gives. An empty member is not given.
struct StudyAxes {
  std::vector<std::string> scenarios;
  std::vector<std::string> strategies;
  std::vector<std::string> operators;
  std::map<ParameterId, double> parameters;
  std::optional<StudyGrid> grid;
  StudyLimits limits;
  StudySeeds seeds;
};

/// `own`, and the settings of `general` that it does not give; parameters and limits are taken one by one.
StudyAxes inherited(StudyAxes own, const StudyAxes& general);

/// A named row.
struct StudyRow {
  std::string label;
  StudyAxes axes;
  std::map<std::string, PaperValue> paper;
  std::map<std::string, std::vector<double>> measured;  ///< see StudyCell; of the first operator
  std::string location;
};

/// Makes the cells of a row with all its settings: scenarios x strategies x operators x grid, the last varying fastest.
/// Labels name the row and all settings with more than one value. cellCount() is the size of this product, which may be
/// too large to be listed.
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
