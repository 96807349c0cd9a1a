#pragma once

#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// Gives the whole application the palette and style sheet of a theme (Fusion style). BrightText is the
/// colour of texts about what is wrong.
void applyTheme(Theme theme);

/// The size of all texts of the application.
void setFontPoints(double points);

}  // namespace glissade
