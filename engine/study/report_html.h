#pragma once

#include <string>

#include "engine/study/study_report.h"

namespace glissade {

/// A report as one HTML page that needs nothing else: plots are inline SVG, pictures data URLs, the
/// style sheet has a light, a dark and a printed form. Well-formed XML. A picture that cannot be read is
/// the error.
Result<std::string> reportHtml(const StudyReport& report);

/// RFC 4648, with padding.
std::string base64(const std::string& bytes);

}  // namespace glissade
