#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/study/study.h"

namespace glissade {

/// What a study varies, before its cells are spelled out.
struct StudyAxes {
  std::vector<std::string> scenarios;
  std::vector<std::string> strategies;
  std::vector<std::string> operators{"none"};
  std::map<ParameterId, double> settings;
  std::vector<std::pair<ParameterId, std::vector<double>>> grid;
  std::uint64_t memoryLimitMb = 0;
  std::vector<std::uint64_t> seeds;
};

/// A named row: what it says replaces or adds to what the study says for all.
struct StudyRow {
  std::string label;
  StudyAxes axes;  ///< with the row's own words already in force
  std::map<std::string, PaperValue> paper;
  std::string location;
};

/// Cells of a row: scenarios x strategies x operators x grid, the last varying fastest. Labels name
/// the row and whatever takes more than one value.
/// Their number first: a product that may be too large to be spelled out.
double cellCount(const StudyRow& row);
std::vector<StudyCell> cellsOf(const StudyRow& row);

/// "environment-1" of "../environment-1/scenario.json", and "tight-star": enough to tell scenarios apart.
std::string scenarioName(const std::string& scenario);

/// Limits of a run are parameters; in a study they are not varied.
bool isLimit(ParameterId id);

/// Adds a part to a text whose parts are separated by commas.
void appendPart(std::string& text, const std::string& part);

}  // namespace glissade
