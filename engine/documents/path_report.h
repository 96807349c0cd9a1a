#pragma once

#include <functional>

#include "engine/documents/document_words.h"
#include "engine/documents/report.h"
#include "engine/files/scenario.h"
#include "engine/planning/clearance_profile.h"

namespace glissade {

/// Content of the report of a path. The references must be valid during the call.
struct PathReportContent {
  const Path& path;  ///< certified path
  const LoadedScenario& scenario;
  PathProvenance provenance;
  const ClearanceProfile* profile = nullptr;  ///< distances along the path; null: no curve
  ReportPicture overview{};                   ///< without a file: no picture
  ReportPicture tightest{};                   ///< picture of the place with the smallest clearance
};

/// The report of one path: problem, certificate with its allowances and conditions, pictures, the clearance along the
/// path, parameters, and the parts with the hashes of their files. `length` formats a length for people.
Report pathReport(const PathReportContent& content, const DocumentWords& words,
                  const std::function<std::string(double metres)>& length);

}  // namespace glissade
