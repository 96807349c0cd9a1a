#pragma once

#include <vector>

#include "engine/study/study_report.h"

namespace glissade {

/// What the page of results says of one study: findings, `auto` beside the best of the others on every
/// scenario, plots, how runs ended and seconds. The study's own report has the rest.
std::vector<ReportBlock> planningSection(const StudyFolder& folder, Warnings& warnings);

}  // namespace glissade
