#pragma once

#include "engine/base/json_reader.h"
#include "engine/study/finding.h"
#include "engine/study/study_json.h"

namespace glissade::study_json {

/// Reads one of "findings". Throws JsonError. Private to this folder.
Finding readFinding(const JsonCursor& at);

/// The inverse: readFinding(toJson(f)) is f.
Json toJson(const Finding& finding);

/// Reads measure, statistic and over; for success_rate only the first.
Quantity readQuantity(const JsonCursor& at);

/// Reads a name that must be one of `known`; `what` describes it in the message.
std::string readOneOf(const JsonCursor& at, const std::vector<std::string>& known, CatalogueText what);

}  // namespace glissade::study_json
