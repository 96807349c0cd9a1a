#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "engine/base/result.h"
#include "engine/sequence/work_times.h"

namespace glissade {

/// A table of work times as a file: "format": "glissade-work-times", "version": 1, and "times" with a member for each
/// row of workTimeRows(). A missing member keeps its default.
nlohmann::ordered_json toJson(const WorkTimes& times);

/// Checks a value. Error: MalformedInput with the JSON pointer as place where it is outside of the range of its row.
Outcome checkWorkTime(const WorkTimeRow& row, double value);

/// Reads a table. Errors: MalformedInput with the JSON pointer as place.
Result<WorkTimes> readWorkTimes(const std::string& file);

/// Saves a table atomically.
Outcome saveWorkTimes(const WorkTimes& times, const std::string& file);

}  // namespace glissade
