#pragma once

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// Commits the text of the line or box that has the focus, as Enter does; the focus stays.
void commitEditorInUse();

/// Calls commitEditorInUse() before every action. It must be called before anything else is connected to the actions.
void commitBefore(const ActionCatalogue& actions);

}  // namespace glissade
