#include "engine/study/summary_json.h"

#include "engine/import/json_reader.h"
#include "engine/study/repeat_command.h"
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
  json["settings"] = study_json::parameters(cell.settings);
  json["parameters"] = study_json::parameters(cell.parameters);
  json["planned"] = summary.planned;
  json["runs"] = summary.runs;
  for (std::size_t i = 0; i < kRunStatusCount; ++i) {
    json["statuses"][name(static_cast<RunStatus>(i))] = summary.statuses[i];
  }
  json["success_rate"] = {
      {"share", summary.success.share}, {"wilson95_low", summary.success.low}, {"wilson95_high", summary.success.high}};
  for (const MeasureSummary& measure : summary.measures) {
    json["measures"][measure.name] = {{"solved", toJson(measure.solved)}, {"all", toJson(measure.all)}};
  }
  json["paper"] = study_json::paper(cell.paper);
  json["command"] = repeatCommand(cell, cell.seeds.front());
  return json;
}

}  // namespace

std::string summaryJson(const StudyFolder& folder, const std::vector<CellSummary>& summaries) {
  const StudyPlan& plan = folder.plan();
  Json json;
  json["format"] = "glissade-study-summary";
  json["version"] = 1;
  json["glissade"] = plan.version;
  json["study_sha256"] = plan.studySha256;
  json["plan_sha256"] = folder.planSha256();
  json["quick"] = plan.study.quick;
  study_json::addHeading(json, plan.study.heading);
  json["cells"] = Json::array();
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    json["cells"].push_back(toJson(i, plan.study.cells[i], summaries[i]));
  }
  return jsonText(json, 1) + "\n";
}

}  // namespace glissade
