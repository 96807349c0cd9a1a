#pragma once

#include <QString>
#include <optional>

#include "engine/base/diagnostic.h"

namespace glissade {

class StudyController;
struct Workbench;

/// Runs the median run (by nodes) of every cell with a solved run again, offscreen, and saves the 3D view
/// as DIR/pictures/cellN.png with its caption in cellN.txt. What went wrong, or nothing.
std::optional<Diagnostic> takeStudyPictures(const QString& folder, const Workbench& bench, StudyController& studies);

/// Writes DIR/report.pdf of a study's results, or DIR/benchmarks.pdf of what packaging/benchmarks.sh filled.
std::optional<Diagnostic> writeFolderPdf(const QString& folder);

}  // namespace glissade
