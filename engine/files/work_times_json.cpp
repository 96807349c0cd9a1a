#include "engine/files/work_times_json.h"

#include <algorithm>

#include "engine/base/file.h"
#include "engine/base/file_save.h"
#include "engine/base/json_reader.h"
#include "engine/base/limits.h"

namespace glissade {
namespace {

constexpr const char* kTableFormat = "glissade-work-times";
constexpr int kTableVersion = 1;

bool isRow(const std::string& name) {
  const auto& rows = workTimeRows();
  return std::any_of(rows.begin(), rows.end(), [&](const WorkTimeRow& row) { return row.id == name; });
}

WorkTimes timesIn(const JsonCursor& at) {
  at.allowOnly({"format", "version", "description", "times"});
  if (at.at("format").text() != kTableFormat) at.at("format").fail({GLISSADE_TEXT("is not %1"), {kTableFormat}});
  if (at.at("version").number() != kTableVersion) at.at("version").fail({GLISSADE_TEXT("is not %1"), {kTableVersion}});
  const JsonCursor rows = at.at("times");
  rows.expectObject();
  for (const auto& [name, value] : rows.json().items()) {
    if (!isRow(name))
      rows.at(name).fail(GLISSADE_TEXT("is no work time"),
                         GLISSADE_TEXT("Take the names that 'times --write-table' writes."));
  }
  WorkTimes times;
  for (const WorkTimeRow& row : workTimeRows()) {
    const auto found = rows.find(row.id);
    if (!found) continue;
    const double value = found->number();
    if (const Outcome fits = checkWorkTime(row, value); !fits) found->fail(fits.error().reason);
    times.*row.value = value;
  }
  return times;
}

}  // namespace

nlohmann::ordered_json toJson(const WorkTimes& times) {
  nlohmann::ordered_json json{{"format", kTableFormat}, {"version", kTableVersion}};
  json["description"] =
      "Seconds of manual work and the limits between its cases. The defaults are estimates of the size of the tables "
      "for manual assembly in Boothroyd, Dewhurst and Knight, Product Design for Manufacture and Assembly (2011).";
  for (const WorkTimeRow& row : workTimeRows()) json["times"][row.id] = times.*row.value;
  return json;
}

Outcome checkWorkTime(const WorkTimeRow& row, double value) {
  if (value >= 0.0 && value <= row.most) return Done{};
  return Diagnostic{ErrorKind::MalformedInput,
                    "",
                    std::string("/times/") + row.id,
                    {GLISSADE_TEXT("is not from 0 to %1"), {row.most}},
                    {}};
}

Result<WorkTimes> readWorkTimes(const std::string& file) {
  const auto text = readFile(file, limits::kMostScenarioBytes);
  if (!text) return text.error();
  return readJson(*text, file, timesIn);
}

Outcome saveWorkTimes(const WorkTimes& times, const std::string& file) {
  const SaveResult saved = saveFile(file, jsonText(toJson(times), 2) + "\n");
  return saved ? Outcome(Done{}) : Outcome(saved.why);
}

}  // namespace glissade
