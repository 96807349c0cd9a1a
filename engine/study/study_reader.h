#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/base/result.h"
#include "engine/study/study.h"

namespace glissade {

/// Largest size of a study file.
inline constexpr std::size_t kMostStudyBytes = 16U << 20;

/// Reads study JSON ("glissade-study", version 1; schema in resources/schema) and lists its cells: rows x scenarios x
/// strategies x operators x grid, in this order. `quick` applies the section of that name. Unknown keys, strategies,
/// operators and parameters, wrong types and cells without any limit are MalformedInput errors with the JSON pointer as
/// location.
Result<Study> parseStudy(const std::string& text, const std::string& file, bool quick);

/// The JSON schema of studies: resources/schema/study-1.schema.json.
nlohmann::ordered_json studySchema();

}  // namespace glissade
