#pragma once

#include "engine/study/study_report.h"
#include "engine/study/study_summary.h"

namespace glissade::study_report {

/// The tables of a report. Private to it.

ReportTable paperTable(const Study& study, const std::vector<CellSummary>& summaries, const StudyWords& words);
/// What the study's author remarks on the paper's rows; no rows where nothing.
ReportTable notesTable(const Study& study, const StudyWords& words);
ReportTable findingsTable(const Study& study, const std::vector<CellSummary>& summaries, const StudyWords& words);
ReportTable endingsTable(const Study& study, const std::vector<CellSummary>& summaries, const StudyWords& words);
ReportTable timingTable(const Study& study, const std::vector<CellSummary>& summaries, const StudyWords& words);

}  // namespace glissade::study_report
