#include "engine/base/json_reader.h"
#include "engine/study/finding_reader.h"
#include "engine/study/study_json.h"
#include "engine/study/study_plan.h"

namespace glissade {
namespace {

using Json = JsonCursor::Json;

Json toJson(const StudyCell& cell) {
  return {{"label", cell.label},
          {"row", cell.row},
          {"scenario", cell.scenario},
          {"scenario_sha256", cell.scenarioSha256},
          {"strategy", cell.strategy},
          {"operator", cell.operatorName},
          {"settings", study_json::parameters(cell.settings)},
          {"parameters", study_json::parameters(cell.parameters)},
          {"memory_limit_mb", cell.memoryLimitMb},
          {"seeds", cell.seeds},
          {"paper", study_json::paper(cell.paper)}};
}

std::map<ParameterId, double> readParameters(const JsonCursor& object) {
  object.expectObject();
  std::map<ParameterId, double> values;
  for (const auto& item : object.json().items()) {
    const JsonCursor at = object.at(item.key());
    const auto id = parameterByKey(item.key());
    if (!id) at.fail(GLISSADE_TEXT("is not a parameter"));
    values[*id] = at.number();
  }
  return values;
}

/// Reads all parameters that were in force. A parameter that was added after the study was run gets its default, which
/// gives the former behaviour. Parameters that depend on the object existed from the beginning.
std::map<ParameterId, double> readAllParameters(const JsonCursor& object) {
  std::map<ParameterId, double> values = readParameters(object);
  for (const ParameterSpec& spec : parameterTable()) {
    if (values.count(spec.id) != 0) continue;
    if (spec.scale != ParameterScale::Absolute) object.fail({GLISSADE_TEXT("has no '%1'"), {spec.key}});
    values[spec.id] = spec.defaultValue;
  }
  return values;
}

std::map<std::string, PaperValue> readPaper(const JsonCursor& object) {
  object.expectObject();
  std::map<std::string, PaperValue> values;
  for (const auto& item : object.json().items()) {
    const JsonCursor at = object.at(item.key());
    values[item.key()] = at.isString() ? PaperValue(at.text()) : PaperValue(at.number());
  }
  return values;
}

StudyCell readCell(const JsonCursor& at) {
  at.allowOnly({"label", "row", "scenario", "scenario_sha256", "strategy", "operator", "settings", "parameters",
                "memory_limit_mb", "seeds", "paper"});
  StudyCell cell;
  cell.label = at.at("label").text();
  cell.row = at.at("row").text();
  cell.scenario = at.at("scenario").nonEmptyText();
  cell.scenarioSha256 = at.at("scenario_sha256").text();
  cell.strategy = at.at("strategy").nonEmptyText();
  cell.operatorName = at.at("operator").nonEmptyText();
  cell.settings = readParameters(at.at("settings"));
  cell.parameters = readAllParameters(at.at("parameters"));
  cell.memoryLimitMb = at.at("memory_limit_mb").wholeNumber();
  const JsonCursor seeds = at.at("seeds");
  for (std::size_t i = 0; i < seeds.size(); ++i) cell.seeds.push_back(seeds.element(i).wholeNumber());
  cell.paper = readPaper(at.at("paper"));
  if (cell.seeds.empty()) seeds.fail(GLISSADE_TEXT("is empty"));
  return cell;
}

StudyPlan read(const JsonCursor& root) {
  root.allowOnly({"format", "version", "glissade", "study_sha256", "quick", "name", "title", "description", "citation",
                  "paper", "findings", "cells"});
  if (root.at("format").text() != "glissade-study-plan")
    root.at("format").fail(GLISSADE_TEXT("is not \"glissade-study-plan\""));
  if (root.at("version").wholeNumber() != 1)
    root.at("version").fail(GLISSADE_TEXT("is not 1"), GLISSADE_TEXT("Use a newer Glissade."));
  StudyPlan plan;
  plan.version = root.at("glissade").text();
  plan.studySha256 = root.at("study_sha256").text();
  plan.study.quick = root.at("quick").boolean();
  StudyHeading& heading = plan.study.heading;
  heading.name = root.at("name").nonEmptyText();
  heading.title = root.at("title").nonEmptyText();
  heading.description = root.at("description").text();
  heading.citation = root.at("citation").text();
  const JsonCursor columns = root.at("paper");
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const JsonCursor at = columns.element(i);
    heading.paper.push_back({at.at("key").text(),
                             at.at("title").text(),
                             {at.at("measure").text(), at.at("statistic").text(), at.at("over").text()}});
  }
  if (const auto findings = root.find("findings")) {
    for (std::size_t i = 0; i < findings->size(); ++i) {
      heading.findings.push_back(study_json::readFinding(findings->element(i)));
    }
  }
  const JsonCursor cells = root.at("cells");
  if (cells.size() == 0) cells.fail(GLISSADE_TEXT("is empty"));
  for (std::size_t i = 0; i < cells.size(); ++i) plan.study.cells.push_back(readCell(cells.element(i)));
  return plan;
}

}  // namespace

std::string writePlan(const StudyPlan& plan) {
  Json json;
  json["format"] = "glissade-study-plan";
  json["version"] = 1;
  json["glissade"] = plan.version;
  json["study_sha256"] = plan.studySha256;
  json["quick"] = plan.study.quick;
  study_json::addHeading(json, plan.study.heading);
  json["cells"] = Json::array();
  for (const StudyCell& cell : plan.study.cells) json["cells"].push_back(toJson(cell));
  return jsonText(json, 1) + "\n";
}

Result<StudyPlan> readPlan(const std::string& text, const std::string& file) { return readJson(text, file, read); }

}  // namespace glissade
