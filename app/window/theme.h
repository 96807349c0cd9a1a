#pragma once

#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// Gives the application the palette and style sheet of a theme (Fusion style). BrightText is the colour of texts about
/// errors.
void applyTheme(Theme theme);

/// Sets the size of all texts of the application.
void setFontPoints(double points);

}  // namespace glissade
