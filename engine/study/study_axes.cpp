#include "engine/study/study_axes.h"

#include <filesystem>
#include <numeric>

#include "engine/base/number_text.h"

namespace glissade {
namespace {

/// One value of each grid parameter.
using GridPoint = std::vector<std::pair<ParameterId, double>>;

std::vector<GridPoint> pointsOf(const StudyAxes& axes) {
  std::vector<GridPoint> points{{}};
  for (const auto& [id, values] : axes.grid.value_or(StudyGrid())) {
    std::vector<GridPoint> finer;
    for (const GridPoint& point : points) {
      for (const double value : values) {
        finer.push_back(point);
        finer.back().emplace_back(id, value);
      }
    }
    points = std::move(finer);
  }
  return points;
}

std::vector<std::uint64_t> seedsOf(const StudySeeds& seeds) {
  if (const auto* list = std::get_if<std::vector<std::uint64_t>>(&seeds)) return *list;
  const auto& range = std::get<SeedRange>(seeds);
  std::vector<std::uint64_t> list(range.count);
  std::iota(list.begin(), list.end(), range.first);
  return list;
}

StudyCell cellOf(const StudyRow& row, const std::string& scenario, const std::string& strategy,
                 const std::string& operatorName, const GridPoint& point) {
  const StudyAxes& axes = row.axes;
  StudyCell cell;
  cell.row = row.label;
  cell.label = row.label;
  if (axes.scenarios.size() > 1) appendPart(cell.label, scenarioName(scenario));
  if (axes.strategies.size() > 1) appendPart(cell.label, strategy);
  if (axes.operators.size() > 1) appendPart(cell.label, operatorName);
  for (const auto& [id, value] : point) appendPart(cell.label, std::string(specOf(id).key) + "=" + toText(value));
  cell.scenario = scenario;
  cell.strategy = strategy;
  cell.operatorName = operatorName;
  cell.settings = axes.parameters;
  cell.settings.insert(axes.limits.settings.begin(), axes.limits.settings.end());
  for (const auto& [id, value] : point) cell.settings[id] = value;
  cell.memoryLimitMb = axes.limits.memoryMb.value_or(0);
  cell.seeds = seedsOf(axes.seeds);
  cell.paper = row.paper;
  if (!axes.operators.empty() && operatorName == axes.operators.front()) cell.measured = row.measured;
  cell.location = row.location;
  return cell;
}

}  // namespace

std::uint64_t seedCount(const StudySeeds& seeds) {
  if (const auto* list = std::get_if<std::vector<std::uint64_t>>(&seeds)) return list->size();
  return std::get<SeedRange>(seeds).count;
}

StudyAxes inherited(StudyAxes own, const StudyAxes& general) {
  if (own.scenarios.empty()) own.scenarios = general.scenarios;
  if (own.strategies.empty()) own.strategies = general.strategies;
  if (own.operators.empty()) own.operators = general.operators;
  own.parameters.insert(general.parameters.begin(), general.parameters.end());
  if (!own.grid) own.grid = general.grid;
  own.limits.settings.insert(general.limits.settings.begin(), general.limits.settings.end());
  if (!own.limits.memoryMb) own.limits.memoryMb = general.limits.memoryMb;
  if (seedCount(own.seeds) == 0) own.seeds = general.seeds;
  return own;
}

std::string scenarioName(const std::string& scenario) {
  const std::filesystem::path path(scenario);
  const std::string stem = path.stem().string();
  return stem == "scenario" ? path.parent_path().filename().string() : stem;
}

double cellCount(const StudyRow& row) {
  double count =
      static_cast<double>(row.axes.scenarios.size() * row.axes.strategies.size() * row.axes.operators.size());
  for (const auto& [id, values] : row.axes.grid.value_or(StudyGrid())) count *= static_cast<double>(values.size());
  return count;
}

std::vector<StudyCell> cellsOf(const StudyRow& row) {
  const std::vector<GridPoint> points = pointsOf(row.axes);
  std::vector<StudyCell> cells;
  for (const std::string& scenario : row.axes.scenarios) {
    for (const std::string& strategy : row.axes.strategies) {
      for (const std::string& operatorName : row.axes.operators) {
        for (const GridPoint& point : points) {
          cells.push_back(cellOf(row, scenario, strategy, operatorName, point));
        }
      }
    }
  }
  return cells;
}

bool isLimit(ParameterId id) {
  return id == ParameterId::TimeLimit || id == ParameterId::MaxSteps || id == ParameterId::MaxSamples ||
         id == ParameterId::StepsPerSecond;
}

void appendPart(std::string& text, const std::string& part) { text += (text.empty() ? "" : ", ") + part; }

}  // namespace glissade
