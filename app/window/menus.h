#pragma once

#include <QMainWindow>
#include <QMenu>
#include <vector>

#include "widgets/commands/action_catalogue.h"

namespace glissade {

/// Fills the menu bar and adds the tool bar, from the action catalogue. `fileMenus` join the File menu,
/// `namedViews` the View menu. The docks are there already: the menu Panels lists them.
void makeMenus(QMainWindow& window, const ActionCatalogue& actions, const std::vector<QMenu*>& fileMenus,
               QMenu* namedViews);

}  // namespace glissade
