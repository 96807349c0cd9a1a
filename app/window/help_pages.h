#pragma once

#include <QWidget>

#include "widgets/commands/action_catalogue.h"

namespace glissade {

/// Dialogs: how to steer, and all shortcuts; what the program is.
void showShortcuts(const ActionCatalogue& actions, QWidget* parent);
void showAbout(QWidget* parent);

}  // namespace glissade
