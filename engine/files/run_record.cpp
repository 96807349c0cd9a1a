#include "engine/files/run_record.h"

#include <glissade/version.h>

#include <filesystem>

#include "engine/base/file.h"
#include "engine/files/run_record_json.h"
#include "engine/files/scenario_io.h"
#include "engine/import/json_checksum.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;
using Json = JsonCursor::Json;

constexpr std::size_t kMostRecordBytes = 256U << 20;

/// Text with one key per line and one list entry per line, so that long streams stay readable and small.
std::string text(const Json& json) {
  std::string result = "{";
  for (const auto& item : json.items()) {
    result += (result.size() > 1 ? ",\n " : "\n ") + jsonText(item.key()) + ": ";
    if (!item.value().is_array() || item.value().empty()) {
      result += jsonText(item.value());
      continue;
    }
    std::string separator = "[\n  ";
    for (const Json& entry : item.value()) {
      result += separator + jsonText(entry);
      separator = ",\n  ";
    }
    result += "\n ]";
  }
  return result + "\n}\n";
}

/// The path relative to the record's folder, so that both may be moved together.
std::string relativeTo(const std::string& folder, const std::string& file) {
  std::error_code ignored;
  const fs::path relative = fs::relative(file, folder, ignored);
  return relative.empty() ? file : relative.generic_string();
}

/// Searches for the scenario relative to the record, to the current folder, and beside the record.
std::string findScenario(const std::string& named, const std::string& recordFile) {
  const fs::path folder = folderOf(recordFile);
  for (const fs::path& candidate : {folder / named, fs::path(named), folder / fs::path(named).filename()}) {
    std::error_code ignored;
    if (fs::is_regular_file(candidate, ignored)) return candidate.lexically_normal().string();
  }
  return named;
}

}  // namespace

Result<RunRecord> makeRunRecord(const LoadedScenario& scenario, RunLog log) {
  RunRecord record;
  record.program = std::string("Glissade ") + kVersion;
  record.build = kBuild;
  std::error_code ignored;
  record.scenario = fs::absolute(scenario.file, ignored).lexically_normal().string();
  record.problemSha256 = scenario.problemSha256;
  for (const Asset& asset : scenario.scenario.assets) {
    const auto hash = assetSha256(asset, scenario.file);
    if (!hash) return hash.error();
    record.assets.push_back({asset.id, *hash});
  }
  setLog(std::move(log), record);
  return record;
}

void setLog(RunLog log, RunRecord& record) {
  for (const ParameterSpec& spec : parameterTable()) record.parameters[spec.id] = log.start.parameters[spec.id];
  record.log = std::move(log);
}

SaveResult writeRunRecord(const RunRecord& record, const std::string& file) {
  Json json = kObject<RunRecord>.write(record);
  json["scenario"] = relativeTo(folderOf(file), record.scenario);
  addChecksum(json);
  return saveFile(file, text(json));
}

Result<RunRecord> readRunRecord(const std::string& file, const WorkWatch& watch) {
  constexpr double kParsing = 0.8;  // share of the work; the rest is reading the values
  const auto content = readFile(file, kMostRecordBytes);
  if (!content) return content.error();
  auto document = isJournal(*content) ? mergedJournal(*content, file, watch.part(0.0, kParsing))
                                      : parseJson(*content, file, watch.part(0.0, kParsing));
  if (!document) return document.error();
  const ChecksumState checksum = takeChecksum(*document);
  try {
    RunRecord record = readRecord(*document, file, watch.part(kParsing, 1.0));
    if (checksum == ChecksumState::Wrong) {
      return wrongChecksum(file,
                           GLISSADE_TEXT("Use an undamaged copy. To replay an edited recording, remove its checksum."));
    }
    record.scenario = findScenario(record.scenario, file);
    return record;
  } catch (const JsonError& error) {
    return error.diagnostic;
  }
}

std::optional<Diagnostic> lossWarning(const RunRecord& record, const std::string& file) {
  if (!record.loss) return std::nullopt;
  return Diagnostic{
      ErrorKind::MalformedInput,
      file,
      "",
      {GLISSADE_TEXT("is damaged: %1 {1|line of the journal is|lines of the journal are} lost"), {record.loss->lines}},
      {GLISSADE_TEXT("Nothing is missing until step %1; the replay may differ from the run after it."),
       {record.loss->afterStep}}};
}

}  // namespace glissade
