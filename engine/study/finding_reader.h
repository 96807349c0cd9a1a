#pragma once

#include "engine/base/json_reader.h"
#include "engine/study/finding.h"
#include "engine/study/study_json.h"

namespace glissade::study_json {

/// Reads one of "findings". Throws JsonError. Private to this room.
Finding readFinding(const JsonCursor& at);

/// And back: readFinding(toJson(f)) is f.
Json toJson(const Finding& finding);

/// Reads measure, statistic and over; of success_rate only the first.
Quantity readQuantity(const JsonCursor& at);

/// A name that is one of those known; what it is for the message.
std::string readOneOf(const JsonCursor& at, const std::vector<std::string>& known, const std::string& what);

}  // namespace glissade::study_json
