#pragma once

#include "engine/study/study_report.h"
#include "engine/study/study_summary.h"

namespace glissade::study_report {

/// The tables of a report. Private to it.

ReportTable paperTable(const Study& study, const std::vector<CellSummary>& summaries);
/// What the study's author remarks on the paper's rows; no rows where nothing.
ReportTable notesTable(const Study& study);
ReportTable findingsTable(const Study& study, const std::vector<CellSummary>& summaries);
ReportTable endingsTable(const Study& study, const std::vector<CellSummary>& summaries);
ReportTable timingTable(const Study& study, const std::vector<CellSummary>& summaries);

}  // namespace glissade::study_report
