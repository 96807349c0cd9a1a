#pragma once

#include "engine/study/study_report.h"
#include "engine/study/study_summary.h"

namespace glissade::study_report {

/// The tables of a report. Private to the report.

ReportTable paperTable(const Study& study, const std::vector<CellSummary>& summaries, const StudyWords& words);
/// The study's notes on the paper's rows; without rows where there are none.
ReportTable notesTable(const Study& study, const StudyWords& words);
ReportTable findingsTable(const Study& study, const std::vector<CellSummary>& summaries, const StudyWords& words);
ReportTable endingsTable(const Study& study, const std::vector<CellSummary>& summaries, const StudyWords& words);
ReportTable timingTable(const Study& study, const std::vector<CellSummary>& summaries, const StudyWords& words);

}  // namespace glissade::study_report
