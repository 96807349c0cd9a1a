#pragma once

#include <QString>

#include "engine/study/study_report.h"

namespace glissade {

/// Writes a report as A4 pages: text that can be searched, plots as vectors, page numbers. Needs a
/// QGuiApplication for its fonts.
Outcome writeReportPdf(const StudyReport& report, const QString& file);

}  // namespace glissade
