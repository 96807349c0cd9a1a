#pragma once

#include <nlohmann/json.hpp>

#include "engine/study/study.h"

namespace glissade::study_json {

using Json = nlohmann::ordered_json;

/// Conversions of values in the files of this folder. Private to it.

/// A number for JSON; whole numbers have no decimal point.
Json number(double value);
Json parameters(const std::map<ParameterId, double>& values);
Json paper(const std::map<std::string, PaperValue>& values);
/// Adds name, title, description, citation and the paper's columns.
void addHeading(Json& json, const StudyHeading& heading);

}  // namespace glissade::study_json
