#include "engine/scenario/run_record.h"

#include <glissade/version.h>

#include "engine/base/file.h"
#include "engine/scenario/json_reader.h"

namespace glissade {
namespace {

using Json = JsonCursor::Json;

constexpr std::size_t kMostBytes = 1U << 30;

ParameterId readParameterId(const JsonCursor& at, const std::string& key) {
  const auto id = parameterByKey(key);
  if (!id) at.fail("names the unknown parameter '" + key + "'");
  return *id;
}

/// A step that does not come before the one above it: a replay goes through them in order.
std::uint64_t readStep(const JsonCursor& at, std::uint64_t earliest) {
  const std::uint64_t step = at.wholeNumber();
  if (step < earliest) at.fail("comes before the step above it");
  return step;
}

RunRecord read(const JsonCursor& root) {
  root.allowOnly({"format", "version", "program", "scenario", "scenario_sha256", "planner", "seed", "parameters",
                  "parameter_changes", "had_operator", "operator_stream", "nodes"});
  if (root.at("format").text() != "glissade-run") root.at("format").fail("is not \"glissade-run\"");
  if (root.at("version").wholeNumber() != 1) root.at("version").fail("is not 1", "Use a newer Glissade.");
  RunRecord record;
  record.scenario = root.at("scenario").text();
  record.scenarioSha256 = root.at("scenario_sha256").text();
  record.planner = root.at("planner").nonEmptyText();
  record.seed = root.at("seed").wholeNumber();
  record.nodes = root.at("nodes").wholeNumber();
  record.hadOperator = root.at("had_operator").boolean();
  const JsonCursor parameters = root.at("parameters");
  for (const auto& item : parameters.json().items()) {
    const JsonCursor at = parameters.at(item.key());
    record.parameters[readParameterId(at, item.key())] = at.number();
  }
  const JsonCursor changes = root.at("parameter_changes");
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const JsonCursor at = changes.element(i);
    at.allowOnly({"step", "parameter", "value"});
    const std::uint64_t earliest = record.parameterChanges.empty() ? 0 : record.parameterChanges.back().step;
    record.parameterChanges.push_back({readStep(at.at("step"), earliest),
                                       readParameterId(at.at("parameter"), at.at("parameter").text()),
                                       at.at("value").number()});
  }
  const JsonCursor stream = root.at("operator_stream");
  for (std::size_t i = 0; i < stream.size(); ++i) {
    const JsonCursor at = stream.element(i);
    at.allowOnly({"step", "q"});
    const std::uint64_t earliest = record.operatorStream.empty() ? 0 : record.operatorStream.back().step;
    record.operatorStream.push_back({readStep(at.at("step"), earliest), at.at("q").pose()});
  }
  return record;
}

}  // namespace

Outcome writeRunRecord(const RunRecord& record, const std::string& file) {
  Json json;
  json["format"] = "glissade-run";
  json["version"] = 1;
  json["program"] = std::string("Glissade ") + kVersion;
  json["scenario"] = record.scenario;
  json["scenario_sha256"] = record.scenarioSha256;
  json["planner"] = record.planner;
  json["seed"] = record.seed;
  json["parameters"] = Json::object();
  for (const auto& [id, value] : record.parameters) json["parameters"][std::string(specOf(id).key)] = value;
  json["parameter_changes"] = Json::array();
  for (const auto& change : record.parameterChanges) {
    json["parameter_changes"].push_back(
        {{"step", change.step}, {"parameter", std::string(specOf(change.id).key)}, {"value", change.value}});
  }
  json["had_operator"] = record.hadOperator;
  json["nodes"] = record.nodes;
  json["operator_stream"] = Json::array();
  for (const auto& entry : record.operatorStream) {
    json["operator_stream"].push_back({{"step", entry.step}, {"q", toJson(entry.q_device)}});
  }
  return writeFileAtomically(file, json.dump(1) + "\n");
}

Result<RunRecord> readRunRecord(const std::string& file) {
  const auto text = readFile(file, kMostBytes);
  if (!text) return text.error();
  const auto document = parseJson(*text, file);
  if (!document) return document.error();
  try {
    return read(JsonCursor(*document, file, ""));
  } catch (const JsonError& error) {
    return error.diagnostic;
  }
}

}  // namespace glissade
