#pragma once

#include <QString>

#include "engine/base/file_save.h"
#include "engine/study/study_report.h"

namespace glissade {

/// Writes a report as A4 pages: text that can be searched, plots as vectors, page numbers. Needs a
/// QGuiApplication for its fonts.
SaveResult writeReportPdf(const StudyReport& report, const QString& file);

}  // namespace glissade
