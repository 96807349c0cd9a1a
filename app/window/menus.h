#pragma once

#include <QMainWindow>
#include <QMenu>
#include <vector>

#include "widgets/commands/action_catalogue.h"

namespace glissade {

/// Fills the menu bar from the menu table and adds the tool bar. `filledMenus` are those that controllers fill, by
/// their object names. The docks are there already: the menu Panels lists them.
void makeMenus(QMainWindow& window, const ActionCatalogue& actions, const std::vector<QMenu*>& filledMenus);

}  // namespace glissade
