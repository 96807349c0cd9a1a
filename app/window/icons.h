#pragma once

#include <QColor>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// Gives each action with a file resources/icons/ID.svg its icon, in the colour of texts so that it fits the theme.
void applyIcons(const ActionCatalogue& actions, const QColor& colour);

}  // namespace glissade
