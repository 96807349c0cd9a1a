#pragma once

#include <QMainWindow>
#include <QMenu>
#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// Fills the menu bar from the menu table and adds the tool bar. `filledMenus`: the menus that controllers fill, by
/// their object names. Precondition: the docks exist, because the menu Panels lists them.
void makeMenus(QMainWindow& window, const ActionCatalogue& actions, const std::vector<QMenu*>& filledMenus);

}  // namespace glissade
