#pragma once

#include <QString>
#include <optional>

#include "engine/base/diagnostic.h"

namespace glissade {

class StudyController;
struct Workbench;

/// Runs the median solved run (by nodes) of every cell again, offscreen, and saves the 3D view as
/// DIR/pictures/cellN.png with its caption in cellN.txt. Returns the failure, or nothing.
std::optional<Diagnostic> takeStudyPictures(const QString& folder, const Workbench& bench, StudyController& studies);

/// Writes DIR/report.pdf about a study's results, or DIR/benchmarks.pdf about a folder that packaging/benchmarks.sh
/// filled.
std::optional<Diagnostic> writeFolderPdf(const QString& folder);

}  // namespace glissade
