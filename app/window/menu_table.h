#pragma once

#include <vector>

namespace glissade {

/// A menu of the menu bar, or a submenu.
struct MenuSpec {
  const char* id;     ///< "menu.file"
  const char* title;  ///< English, with mnemonic; translated in the context "Menus"
  /// Ids of actions; ids of menus, which become submenus; "" for a separator.
  std::vector<const char*> entries;
};

/// The ids of the menus in the menu bar, in their order.
const std::vector<const char*>& menuBarTable();

/// All menus that are filled from the action catalogue. Every action is in one of these menus, or in one that a
/// controller fills: "menu.recent", "menu.versions", "menu.named-views".
const std::vector<MenuSpec>& menuTable();

}  // namespace glissade
