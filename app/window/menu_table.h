#pragma once

#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// A menu of the menu bar, or a submenu. Actions state their menu in their own rows (ActionSpec::place).
struct MenuSpec {
  const char* id;     ///< "menu.file"
  const char* title;  ///< English, with mnemonic; translated in the context "Menus"; null: a controller fills the menu
  MenuPlace place;    ///< where it is a submenu; no menu: in the menu bar
};

const std::vector<MenuSpec>& menuTable();

}  // namespace glissade
