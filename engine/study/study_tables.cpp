#include "engine/study/study_tables.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "engine/base/csv_table.h"
#include "engine/base/file_save.h"
#include "engine/base/json_reader.h"
#include "engine/study/repeat_command.h"
#include "engine/study/study_axes.h"
#include "engine/study/study_json.h"

namespace glissade {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const Distribution& distribution) {
  Json json{{"count", distribution.count}};
  if (distribution.count == 0) return json;
  json["minimum"] = study_json::number(distribution.minimum);
  json["q1"] = study_json::number(distribution.firstQuartile);
  json["median"] = study_json::number(distribution.median);
  json["q3"] = study_json::number(distribution.thirdQuartile);
  json["maximum"] = study_json::number(distribution.maximum);
  json["mean"] = study_json::number(distribution.mean);
  return json;
}

Json toJson(std::size_t index, const StudyCell& cell, const CellSummary& summary) {
  Json json;
  json["cell"] = index + 1;
  json["label"] = cell.label;
  json["row"] = cell.row;
  json["scenario"] = cell.scenario;
  json["strategy"] = cell.strategy;
  json["operator"] = cell.operatorName;
  json["settings"] = study_json::ParameterNumbersFormat().write(cell.settings);
  json["parameters"] = study_json::ParameterNumbersFormat().write(cell.parameters);
  json["planned"] = summary.planned;
  json["runs"] = summary.runs;
  for (std::size_t i = 0; i < kRunStatusCount; ++i) {
    json["statuses"][kRunStatusNames.of(static_cast<RunStatus>(i))] = summary.statuses[i];
  }
  json["success_rate"] = {
      {"share", summary.success.share}, {"wilson95_low", summary.success.low}, {"wilson95_high", summary.success.high}};
  for (const MeasureSummary& measure : summary.measures) {
    json["measures"][measure.name] = {{"solved", toJson(measure.solved)}, {"all", toJson(measure.all)}};
  }
  json["paper"] = study_json::PaperFormat().write(cell.paper);
  json["command"] = repeatCommand(cell, cell.seeds.front());
  return json;
}

/// The parameters that the cells vary, without limits of runs.
Json axesOf(const Study& study) {
  std::map<ParameterId, std::set<double>> values;
  for (const StudyCell& cell : study.cells) {
    for (const auto& [id, value] : cell.settings) values[id].insert(value);
  }
  Json axes = Json::array();
  for (const auto& [id, seen] : values) {
    if (seen.size() < 2 || isLimit(id)) continue;
    const ParameterSpec& spec = specOf(id);
    axes.push_back({{"key", spec.key}, {"label", spec.label.english}, {"symbol", spec.symbol}, {"unit", spec.unit}});
  }
  return axes;
}

/// summary.json: the study's heading, and for each cell its settings, its summary, the paper's numbers
/// and the command that repeats it. Nothing in it depends on the machine's speed.
std::string summaryJson(const StudyFolder& folder, const std::vector<CellSummary>& summaries) {
  const StudyPlan& plan = folder.plan();
  Json json;
  json["format"] = "glissade-study-summary";
  json["version"] = 1;
  json["glissade"] = plan.version;
  json["study_sha256"] = plan.studySha256;
  json["plan_sha256"] = folder.planSha256();
  json["quick"] = plan.study.quick;
  json.update(writeDescribed(plan.study.heading));
  json["axes"] = axesOf(plan.study);
  json["cells"] = Json::array();
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    json["cells"].push_back(toJson(i, plan.study.cells[i], summaries[i]));
  }
  return jsonText(json, 1) + "\n";
}

void nameCell(CsvTable& table) { table.header({"cell", "label"}); }

void nameSettings(CsvTable& table) {
  table.header({"row", "scenario", "strategy", "operator"});
  for (const ParameterSpec& spec : parameterTable()) table.header({std::string(spec.key)});
}

void addCell(CsvTable& table, std::size_t index, const StudyCell& cell) {
  table.number(static_cast<double>(index + 1));
  table.text(cell.label);
}

void addSettings(CsvTable& table, const StudyCell& cell) {
  table.text(cell.row);
  table.text(cell.scenario);
  table.text(cell.strategy);
  table.text(cell.operatorName);
  for (const ParameterSpec& spec : parameterTable()) table.number(cell.parameters.at(spec.id));
}

std::string runsTable(const Study& study, const StudyResults& results) {
  CsvTable table;
  nameCell(table);
  nameSettings(table);
  table.header({"seed", "status", "solved"});
  for (const ResultColumn& column : resultColumns()) table.header({std::string(column.name)});
  table.header({"certificate", "message"});
  for (const auto& [run, outcome] : results) {
    const RunResult& result = outcome.result;
    table.row();
    addCell(table, run.cell, study.cells[run.cell]);
    addSettings(table, study.cells[run.cell]);
    table.text(std::to_string(run.seed));
    table.text(kRunStatusNames.of(result.status));
    table.text(result.status == RunStatus::Solved ? "1" : "0");
    for (const auto& number : result.numbers) table.number(number);
    table.text(result.certificate);
    table.text(result.message);
  }
  return table.content();
}

std::string timingTable(const Study& study, const StudyResults& results) {
  CsvTable table;
  nameCell(table);
  table.header({"seed", "status", "planning_s", "planning_cpu_s", "wall_s", "cpu_s", "peak_memory_mb"});
  for (const auto& [run, outcome] : results) {
    table.row();
    addCell(table, run.cell, study.cells[run.cell]);
    table.text(std::to_string(run.seed));
    table.text(kRunStatusNames.of(outcome.result.status));
    table.number(outcome.timing.planningSeconds);
    table.number(outcome.timing.planningCpuSeconds);
    table.number(outcome.timing.wallSeconds);
    table.number(outcome.timing.cpuSeconds);
    table.number(outcome.timing.peakMemoryMb);
  }
  return table.content();
}

void nameMeasures(CsvTable& table, const std::vector<MeasureSummary>& measures) {
  for (const MeasureSummary& measure : measures) {
    for (const char* over : {"_solved", "_all"}) {
      for (const char* what : {"_n", "_q1", "_median", "_q3", "_mean"}) table.header({measure.name + over + what});
    }
  }
}

void addDistribution(CsvTable& table, const Distribution& distribution) {
  const bool any = distribution.count > 0;
  table.number(static_cast<double>(distribution.count));
  for (const double value :
       {distribution.firstQuartile, distribution.median, distribution.thirdQuartile, distribution.mean}) {
    table.number(any ? std::optional<double>(value) : std::nullopt);
  }
}

void addMeasures(CsvTable& table, const std::vector<MeasureSummary>& measures) {
  for (const MeasureSummary& measure : measures) {
    addDistribution(table, measure.solved);
    addDistribution(table, measure.all);
  }
}

void addPaper(CsvTable& table, const StudyCell& cell, const std::string& key) {
  const auto found = cell.paper.find(key);
  if (found == cell.paper.end()) return table.text("");
  if (const auto* number = std::get_if<double>(&found->second)) return table.number(*number);
  table.text(std::get<std::string>(found->second));
}

std::string summaryTable(const Study& study, const std::vector<CellSummary>& summaries) {
  CsvTable table;
  nameCell(table);
  nameSettings(table);
  table.header({"planned", "runs", "solved", "success_rate", "success_low", "success_high"});
  for (std::size_t i = 1; i < kRunStatusCount; ++i) {
    table.header({std::string("runs_") + kRunStatusNames.of(static_cast<RunStatus>(i))});
  }
  nameMeasures(table, summaries.front().measures);
  for (const PaperColumn& column : study.heading.paper) table.header({"paper_" + column.key});
  table.header({"paper_note"});
  for (std::size_t c = 0; c < summaries.size(); ++c) {
    const CellSummary& summary = summaries[c];
    table.row();
    addCell(table, c, study.cells[c]);
    addSettings(table, study.cells[c]);
    table.number(static_cast<double>(summary.planned));
    table.number(static_cast<double>(summary.runs));
    table.number(static_cast<double>(summary.solved()));
    table.number(summary.success.share);
    table.number(summary.success.low);
    table.number(summary.success.high);
    for (std::size_t i = 1; i < kRunStatusCount; ++i) table.number(static_cast<double>(summary.statuses[i]));
    addMeasures(table, summary.measures);
    for (const PaperColumn& column : study.heading.paper) addPaper(table, study.cells[c], column.key);
    addPaper(table, study.cells[c], "note");
  }
  return table.content();
}

std::string timingSummaryTable(const Study& study, const std::vector<CellSummary>& summaries) {
  CsvTable table;
  nameCell(table);
  nameMeasures(table, summaries.front().timing);
  for (std::size_t c = 0; c < summaries.size(); ++c) {
    table.row();
    addCell(table, c, study.cells[c]);
    addMeasures(table, summaries[c].timing);
  }
  return table.content();
}

}  // namespace

Outcome writeTables(const StudyFolder& folder, const std::string& out, Warnings& warnings) {
  std::error_code error;
  std::filesystem::create_directories(out, error);
  if (error) {
    return Diagnostic{ErrorKind::Usage,
                      out,
                      "",
                      {GLISSADE_TEXT("cannot be made: %1"), {error.message()}},
                      GLISSADE_TEXT("Choose another --out.")};
  }
  const Study& study = folder.plan().study;
  const StudyResults results = folder.results(warnings);
  const std::vector<CellSummary> summaries = summarise(study, results);
  const std::map<std::string, std::string> files{
      {"runs.csv", runsTable(study, results)},          {"timing.csv", timingTable(study, results)},
      {"summary.csv", summaryTable(study, summaries)},  {"timing_summary.csv", timingSummaryTable(study, summaries)},
      {"summary.json", summaryJson(folder, summaries)},
  };
  for (const auto& [name, content] : files) {
    const Outcome written = saveFile(out + "/" + name, content, warnings);
    if (!written) return written;
  }
  return Done{};
}

}  // namespace glissade
