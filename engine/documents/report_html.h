#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/documents/report.h"

namespace glissade {

/// A report as one HTML page without other files: plots are inline SVG, pictures are data URLs, and the style sheet has
/// light, dark and printed forms. Well-formed XML. Error: a picture cannot be read.
Result<std::string> reportHtml(const Report& report);

/// Base64 by RFC 4648, with padding.
std::string base64(const std::string& bytes);

}  // namespace glissade
