#pragma once

#include <nlohmann/json.hpp>

#include "engine/study/study.h"

namespace glissade::study_json {

using Json = nlohmann::ordered_json;

/// How this room's files say things. Private to it.

/// Whole numbers without a decimal point, as people write counts.
Json number(double value);
Json parameters(const std::map<ParameterId, double>& values);
Json paper(const std::map<std::string, PaperValue>& values);
/// name, title, description, citation and the paper's columns.
void addHeading(Json& json, const StudyHeading& heading);

}  // namespace glissade::study_json
