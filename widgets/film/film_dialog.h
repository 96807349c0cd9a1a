#pragma once

#include "widgets/workbench/workbench.h"

namespace glissade {

/// Asks where to save a film. `what`: the file's proposed name without the product's name and without an ending.
/// Without ffmpeg, a message says so first, and a series of pictures is proposed. Returns an empty name if the person
/// cancels.
QString chooseFilmFile(const Workbench& bench, const QString& title, const QString& what);

}  // namespace glissade
