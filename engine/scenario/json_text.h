#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "engine/base/result.h"
#include "engine/geometry/pose.h"

/// Private to this room: nlohmann/json stays out of the public headers.
namespace glissade {

using Json = nlohmann::ordered_json;

/// Parses JSON strictly. MalformedInput with line and column as place for broken syntax; also for
/// keys given twice, nesting deeper than 32, and more than two million values.
Result<Json> parseJson(const std::string& text, const std::string& file);

/// The one way this program writes JSON: two-space indent, arrays of plain values on one line,
/// numbers that read back as the same double, final newline.
std::string canonicalText(const Json& document);

Json toJson(const Vector3& v);
/// {"position": [x, y, z], "orientation": [x, y, z, w]}.
Json toJson(const Pose& pose);
/// [x, y, z, qx, qy, qz, qw].
Json toRow(const Pose& pose);

}  // namespace glissade
