#pragma once

#include <QString>

#include "engine/base/file_save.h"
#include "engine/documents/report.h"

namespace glissade {

/// Writes a report as A4 pages with searchable text, plots as vectors, and page numbers. Needs a QGuiApplication for
/// its fonts.
SaveResult writeReportPdf(const Report& report, const QString& file);

}  // namespace glissade
