#include "engine/scenario/run_record.h"

#include "engine/import/input_file.h"
#include "engine/scenario/atomic_file.h"
#include "engine/scenario/json_cursor.h"

namespace glissade {
namespace {

constexpr const char* kFormat = "glissade-run";
constexpr std::uint64_t kFormatVersion = 1;
constexpr std::size_t kLargestRecord = std::size_t{64} << 20;

/// The counts of an ending with their keys, once for reading and writing.
struct CountField {
  const char* key;
  std::uint64_t RunRecord::Ending::*member;
};
constexpr CountField kCounts[] = {
    {"steps", &RunRecord::Ending::steps},
    {"iterations", &RunRecord::Ending::iterations},
    {"nodes", &RunRecord::Ending::nodes},
    {"edges", &RunRecord::Ending::edges},
    {"random_configurations", &RunRecord::Ending::randomConfigurations},
    {"operator_configurations", &RunRecord::Ending::operatorConfigurations},
    {"contact_configurations", &RunRecord::Ending::contactConfigurations},
};

std::string keyOf(ParameterId id) { return std::string(specOf(id).key); }

Json toJson(const RunRecord::File& file) { return {{"path", file.path}, {"sha256", file.sha256}}; }

Json toJson(const RunRecord::Ending& ending) {
  Json json{{"status", ending.status}};
  for (const auto& [key, member] : kCounts) json[key] = ending.*member;
  return json;
}

RunRecord::File readFile(const JsonCursor& cursor) {
  cursor.allowOnly({"path", "sha256"});
  return {cursor.at("path").nonEmptyText(), cursor.at("sha256").text()};
}

ParameterId readParameterId(const JsonCursor& cursor, const std::string& key) {
  const std::optional<ParameterId> id = parameterByKey(key);
  if (!id) cursor.fail("there is no parameter '" + key + "'");
  return *id;
}

RunRecord::Ending readEnding(const JsonCursor& cursor) {
  cursor.allowOnly({"status", "steps", "iterations", "nodes", "edges", "random_configurations",
                    "operator_configurations", "contact_configurations"});
  RunRecord::Ending ending;
  ending.status = cursor.at("status").text();
  for (const auto& [key, member] : kCounts) ending.*member = cursor.at(key).wholeNumber();
  return ending;
}

/// The step of an entry, which may not be before that of the entry before it.
std::uint64_t readStep(const JsonCursor& cursor, std::uint64_t earliest) {
  const std::uint64_t step = cursor.wholeNumber();
  if (step < earliest) cursor.fail("this step comes before the one above");
  return step;
}

RunRecord readRecord(const JsonCursor& root) {
  root.allowOnly({"format", "version", "program", "scenario", "assets", "planner", "seed", "parameters",
                  "parameter_changes", "operator_stream", "ending"});
  if (root.at("format").text() != kFormat) root.at("format").fail("this is not a run record");
  if (root.at("version").wholeNumber() != kFormatVersion) {
    root.at("version").fail("this version is not known", "Update Glissade.");
  }
  RunRecord record;
  record.program = root.at("program").text();
  record.scenario = readFile(root.at("scenario"));
  for (const JsonCursor& asset : root.at("assets").elements()) record.assets.push_back(readFile(asset));
  record.planner = root.at("planner").nonEmptyText();
  record.seed = root.at("seed").wholeNumber();
  for (const auto& [key, value] : root.at("parameters").members()) {
    record.parameters[readParameterId(value, key)] = value.number();
  }
  std::uint64_t step = 0;
  for (const JsonCursor& change : root.at("parameter_changes").elements()) {
    change.allowOnly({"step", "parameter", "value"});
    step = readStep(change.at("step"), step);
    const JsonCursor parameter = change.at("parameter");
    record.changes.push_back({step, readParameterId(parameter, parameter.text()), change.at("value").number()});
  }
  step = 0;
  for (const JsonCursor& entry : root.at("operator_stream").elements()) {
    entry.allowOnly({"step", "q_device"});
    step = readStep(entry.at("step"), step);
    record.operatorStream.push_back({step, entry.at("q_device").row()});
  }
  record.ending = readEnding(root.at("ending"));
  return record;
}

}  // namespace

std::string writeRunRecord(const RunRecord& record) {
  Json json{{"format", kFormat},
            {"version", kFormatVersion},
            {"program", record.program},
            {"scenario", toJson(record.scenario)},
            {"assets", Json::array()},
            {"planner", record.planner},
            {"seed", record.seed},
            {"parameters", Json::object()},
            {"parameter_changes", Json::array()},
            {"operator_stream", Json::array()},
            {"ending", toJson(record.ending)}};
  for (const RunRecord::File& asset : record.assets) json["assets"].push_back(toJson(asset));
  for (const auto& [id, value] : record.parameters) json["parameters"][keyOf(id)] = value;
  for (const auto& [step, id, value] : record.changes) {
    json["parameter_changes"].push_back({{"step", step}, {"parameter", keyOf(id)}, {"value", value}});
  }
  for (const auto& [step, q_device] : record.operatorStream) {
    json["operator_stream"].push_back({{"step", step}, {"q_device", toRow(q_device)}});
  }
  return canonicalText(json);
}

Result<RunRecord> parseRunRecord(const std::string& text, const std::string& file) {
  const Result<Json> document = parseJson(text, file);
  if (!document) return document.error();
  try {
    return readRecord(JsonCursor(*document));
  } catch (const JsonFailure& failure) {
    Diagnostic diagnostic = failure.diagnostic;
    diagnostic.file = file;
    return diagnostic;
  }
}

Outcome saveRunRecord(const RunRecord& record, const std::string& file) {
  return writeFileAtomically(file, writeRunRecord(record));
}

Result<RunRecord> loadRunRecord(const std::string& file) {
  const Result<std::string> text = readInputFile(file, kLargestRecord);
  if (!text) return text.error();
  return parseRunRecord(*text, file);
}

}  // namespace glissade
