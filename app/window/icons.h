#pragma once

#include <QColor>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// Gives the actions of the toolbar their icons, in the text's colour so that they fit the theme.
void applyIcons(const ActionCatalogue& actions, const QColor& colour);

}  // namespace glissade
