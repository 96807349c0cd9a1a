#include "engine/study/run_result.h"

#include <algorithm>

#include "engine/base/guarded.h"
#include "engine/base/json_reader.h"
#include "engine/study/study_json.h"

namespace glissade {
namespace {

using Json = JsonCursor::Json;

constexpr std::array<ResultColumn, kResultColumnCount> kColumns{{
    {"nodes", "/nodes", true},
    {"edges", "/edges", true},
    {"dropped_edges", "/dropped_edges", false},
    {"nodes_computer", "/nodes_by_author/computer", true},
    {"nodes_operator", "/nodes_by_author/operator", true},
    {"nodes_contact", "/nodes_by_author/contact", true},
    {"iterations", "/iterations", true},
    {"steps", "/steps", true},
    {"random_configurations", "/random_configurations", true},
    {"operator_configurations", "/operator_configurations", true},
    {"contact_configurations", "/contact_configurations", true},
    {"coarse_configurations", "/coarse_plan/coarse_configurations", true},
    {"fine_configurations", "/coarse_plan/fine_configurations", true},
    {"collision_queries", "/collision_queries", false},
    {"distance_queries", "/distance_queries", false},
    {"virtual_s", "/virtual_s", true},
    {"path_configurations", "/path/configurations", false},
    {"path_length_m", "/path/length_m", true},
    {"path_share_computer", "/path_share_by_author/computer", true},
    {"path_share_operator", "/path_share_by_author/operator", true},
    {"path_share_contact", "/path_share_by_author/contact", true},
    {"path_rotation_rad", "/path/rotation_rad", true},
    {"min_clearance_m", "/certificate/min_clearance_m", true},
    {"tolerance_m", "/certificate/tolerance_m", false},
    {"parts", "/parts", false},
    {"parts_removed", "/removed", true},
    {"sequence_steps", "/steps", true},
}};

std::size_t indexOf(std::string_view column) {
  const auto found =
      std::find_if(kColumns.begin(), kColumns.end(), [&](const auto& each) { return each.name == column; });
  return static_cast<std::size_t>(found - kColumns.begin());
}

/// The first line of a text, limited in length.
std::string firstLine(const std::string& text) {
  constexpr std::size_t kMost = 300;
  return text.substr(0, std::min(text.find('\n'), kMost));
}

std::optional<double> numberAt(const Json& report, std::string_view pointer) {
  const Json::json_pointer where{std::string(pointer)};
  if (!report.contains(where)) return std::nullopt;
  if (report.at(where).is_array()) return static_cast<double>(report.at(where).size());
  if (!report.at(where).is_number()) return std::nullopt;
  return report.at(where).get<double>();
}

std::string textAt(const Json& report, const char* pointer) {
  const Json::json_pointer where(pointer);
  return report.contains(where) && report.at(where).is_string() ? report.at(where).get<std::string>() : "";
}

/// The status in a report of `glissade-cli sequence`; nothing for other reports.
std::optional<RunStatus> statusOfSequence(const Json& report) {
  if (textAt(report, "/format") != "glissade-plan") return std::nullopt;
  const std::string end = textAt(report, "/end");
  if (end == "complete") return RunStatus::Solved;
  return end == "stuck" ? RunStatus::NoPath : RunStatus::Time;
}

/// True if the text says that memory ended, in the words of guarded() or of the standard library. The text is the
/// report's error or standard error, where the name of the program stands before the reason.
bool saysOutOfMemory(const std::string& text) {
  const std::string reason = toString(withoutMemory().reason);
  const std::string line = firstLine(text);
  const std::size_t name = line.rfind(": " + reason);
  const bool endsWithReason = name != std::string::npos && name + 2 + reason.size() == line.size();
  return text.find("bad_alloc") != std::string::npos || line == reason || endsWithReason;
}

RunStatus statusOf(const ChildEnd& end, const Json& report, const RunOutcome& outcome, double timeLimit) {
  if (end.ending == ChildEnding::TimeOver) return RunStatus::Time;
  if (saysOutOfMemory(end.errors) || saysOutOfMemory(outcome.result.message)) return RunStatus::Memory;
  if (end.signal != 0 || !report.is_object()) return RunStatus::Crashed;
  if (const auto sequence = statusOfSequence(report)) return *sequence;
  const std::string said = textAt(report, "/status");
  if (report.contains("error") && said.empty()) return RunStatus::Error;
  const auto status = kRunStatusNames.find(said);
  if (!status) return said == "error" || said == "malformed" ? RunStatus::Error : RunStatus::Crashed;
  const bool outOfTime = timeLimit > 0.0 && outcome.timing.planningSeconds.value_or(0.0) >= timeLimit;
  return *status == RunStatus::LimitReached && outOfTime ? RunStatus::Time : *status;
}

std::string messageOf(const ChildEnd& end, const Json& report) {
  if (end.ending == ChildEnding::TimeOver) return "killed at the end of its time limit";
  if (end.ending == ChildEnding::OutputTooLarge) return "killed because it wrote too much output";
  if (end.signal != 0) return "ended by signal " + std::to_string(end.signal);
  const std::string reason = textAt(report, "/error/reason");
  if (!reason.empty()) return firstLine(reason);
  if (report.is_object()) return "";
  return "no report, exit code " + std::to_string(end.exitCode) + ": " + firstLine(end.errors);
}

}  // namespace

const std::array<ResultColumn, kResultColumnCount>& resultColumns() { return kColumns; }

bool dependsOnMachine(RunStatus status) {
  return status == RunStatus::Time || status == RunStatus::Memory || status == RunStatus::Crashed ||
         status == RunStatus::Error;
}

RunOutcome outcomeOf(const ChildEnd& end, double timeLimit) {
  RunOutcome outcome;
  outcome.timing.wallSeconds = end.wallSeconds;
  outcome.timing.cpuSeconds = end.cpuSeconds;
  outcome.timing.peakMemoryMb = end.peakMemoryMb;
  const Json report = Json::parse(end.output, nullptr, false);
  if (report.is_object()) {
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
      outcome.result.numbers[i] = numberAt(report, kColumns[i].pointer);
    }
    outcome.result.certificate = textAt(report, "/certificate/status");
    outcome.timing.planningSeconds = numberAt(report, "/planning_s");
    if (statusOfSequence(report)) {
      if (outcome.result.numbers[indexOf("parts_removed")].value_or(0.0) > 0.0)
        outcome.result.certificate = "certified";
      outcome.result.numbers[indexOf("steps")].reset();  // the number is that of a planner's steps
      outcome.timing.planningSeconds = numberAt(report, "/wall_s");
    } else {
      outcome.result.numbers[indexOf("sequence_steps")].reset();
    }
    outcome.timing.planningCpuSeconds = numberAt(report, "/planning_cpu_s");
  }
  outcome.result.message = messageOf(end, report);
  outcome.result.status = statusOf(end, report, outcome, timeLimit);
  return outcome;
}

std::string writeRunRow(const RunRow& row) {
  const RunResult& result = row.outcome.result;
  const RunTiming& timing = row.outcome.timing;
  Json json;
  json["format"] = "glissade-study-run";
  json["version"] = 1;
  json["plan_sha256"] = row.plan;
  json["cell"] = row.cell;
  json["seed"] = row.seed;
  json["status"] = kRunStatusNames.of(result.status);
  json["certificate"] = result.certificate;
  json["message"] = result.message;
  json["numbers"] = Json::object();
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    if (result.numbers[i]) json["numbers"][std::string(kColumns[i].name)] = study_json::number(*result.numbers[i]);
  }
  json["timing"]["planning_s"] = timing.planningSeconds ? Json(*timing.planningSeconds) : Json(nullptr);
  json["timing"]["planning_cpu_s"] = timing.planningCpuSeconds ? Json(*timing.planningCpuSeconds) : Json(nullptr);
  json["timing"]["wall_s"] = timing.wallSeconds;
  json["timing"]["cpu_s"] = timing.cpuSeconds ? Json(*timing.cpuSeconds) : Json(nullptr);
  json["timing"]["peak_memory_mb"] = timing.peakMemoryMb;
  return jsonText(json, 1) + "\n";
}

namespace {

std::optional<double> readOptional(const JsonCursor& at) {
  if (at.json().is_null()) return std::nullopt;
  return at.number();
}

/// Reads a value that files of the first versions do not have.
std::optional<double> readIfThere(const JsonCursor& object, const char* key) {
  const auto at = object.find(key);
  return at ? readOptional(*at) : std::nullopt;
}

RunRow readRow(const JsonCursor& root) {
  root.allowOnly(
      {"format", "version", "plan_sha256", "cell", "seed", "status", "certificate", "message", "numbers", "timing"});
  if (root.at("format").text() != "glissade-study-run")
    root.at("format").fail(GLISSADE_TEXT("is not \"glissade-study-run\""));
  if (root.at("version").wholeNumber() != 1)
    root.at("version").fail(GLISSADE_TEXT("is not 1"), GLISSADE_TEXT("Use a newer Glissade."));
  RunRow row;
  row.plan = root.at("plan_sha256").text();
  row.cell = root.at("cell").wholeNumber();
  row.seed = root.at("seed").wholeNumber();
  RunResult& result = row.outcome.result;
  const auto status = kRunStatusNames.find(root.at("status").text());
  if (!status) root.at("status").fail(GLISSADE_TEXT("is not a status"));
  result.status = *status;
  result.certificate = root.at("certificate").text();
  result.message = root.at("message").text();
  const JsonCursor numbers = root.at("numbers");
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    if (const auto at = numbers.find(std::string(kColumns[i].name))) result.numbers[i] = at->number();
  }
  const JsonCursor timing = root.at("timing");
  row.outcome.timing.planningSeconds = readOptional(timing.at("planning_s"));
  row.outcome.timing.planningCpuSeconds = readIfThere(timing, "planning_cpu_s");
  row.outcome.timing.wallSeconds = timing.at("wall_s").number();
  row.outcome.timing.cpuSeconds = readIfThere(timing, "cpu_s");
  row.outcome.timing.peakMemoryMb = timing.at("peak_memory_mb").number();
  return row;
}

}  // namespace

Result<RunRow> readRunRow(const std::string& text, const std::string& file) { return readJson(text, file, readRow); }

}  // namespace glissade
