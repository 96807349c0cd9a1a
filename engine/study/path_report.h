#pragma once

#include <functional>

#include "engine/planning/clearance_profile.h"
#include "engine/scenario/scenario.h"
#include "engine/study/study_report.h"

namespace glissade {

/// What the report of a path is made of. Refers to its members for the time of the call.
struct PathReportContent {
  const Path& path;  ///< certified
  const LoadedScenario& scenario;
  PathProvenance provenance;
  const ClearanceProfile* profile = nullptr;  ///< along the path; null: no curve
  ReportPicture overview{};                   ///< no file: none
  ReportPicture tightest{};                   ///< of the place with the smallest clearance
};

/// The report of one path: problem, certificate with what is allowed and what it is about, pictures, the clearance
/// along the path, parameters, and the parts with the hashes of their files. `length` writes a length for people.
StudyReport pathReport(const PathReportContent& content, const StudyWords& words,
                       const std::function<std::string(double metres)>& length);

}  // namespace glissade
