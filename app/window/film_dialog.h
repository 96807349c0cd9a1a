#pragma once

#include "app/window/workbench.h"

namespace glissade {

/// Asks where a film is saved; `what` is its name without the product's and without an ending. Where ffmpeg is not
/// installed, that is said before, and a series of pictures is proposed. Empty: the person cancels.
QString chooseFilmFile(const Workbench& bench, const QString& title, const QString& what);

}  // namespace glissade
