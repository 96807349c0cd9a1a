#pragma once

#include "widgets/commands/action_catalogue.h"

namespace glissade {

/// What was typed into the line or box that has the focus counts as if Enter had been pressed; the focus stays.
void commitEditorInUse();

/// That before every action; to be called before anything else is connected to them.
void commitBefore(const ActionCatalogue& actions);

}  // namespace glissade
