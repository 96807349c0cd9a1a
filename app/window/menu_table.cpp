#include "app/window/menu_table.h"

#include <QtGlobal>

namespace glissade {

const std::vector<MenuSpec>& menuTable() {
  static const std::vector<MenuSpec> menus{
      {"menu.file", QT_TRANSLATE_NOOP("Menus", "&File"), {"", 1, 10}},
      {"menu.edit", QT_TRANSLATE_NOOP("Menus", "&Edit"), {"", 1, 20}},
      {"menu.view", QT_TRANSLATE_NOOP("Menus", "&View"), {"", 1, 30}},
      {"menu.standard", QT_TRANSLATE_NOOP("Menus", "Standard vie&ws"), {"menu.view", 1, 30}},
      {"menu.navigation", QT_TRANSLATE_NOOP("Menus", "&Navigation"), {"menu.view", 1, 50}},
      {"menu.display", QT_TRANSLATE_NOOP("Menus", "&Display"), {"menu.view", 2, 10}},
      {"menu.stereo", QT_TRANSLATE_NOOP("Menus", "Ster&eo"), {"menu.view", 2, 20}},
      {"menu.headset", QT_TRANSLATE_NOOP("Menus", "He&adset"), {"menu.view", 2, 30}},
      {"menu.layers", QT_TRANSLATE_NOOP("Menus", "&Layers"), {"menu.view", 3, 10}},
      {"menu.place-layers", QT_TRANSLATE_NOOP("Menus", "La&yers of places"), {"menu.view", 3, 20}},
      {"menu.section", QT_TRANSLATE_NOOP("Menus", "Se&ctions"), {"menu.view", 3, 30}},
      {"menu.measure", QT_TRANSLATE_NOOP("Menus", "&Measure"), {"menu.view", 3, 40}},
      {"menu.panels", QT_TRANSLATE_NOOP("Menus", "&Panels"), {"menu.view", 4, 10}},
      {"menu.go", QT_TRANSLATE_NOOP("Menus", "&Go to panel"), {"menu.view", 4, 20}},
      {"menu.assembly", QT_TRANSLATE_NOOP("Menus", "&Assembly"), {"", 1, 40}},
      {"menu.placement", QT_TRANSLATE_NOOP("Menus", "&Placement"), {"menu.assembly", 3, 20}},
      {"menu.ends", QT_TRANSLATE_NOOP("Menus", "S&tart and goal"), {"menu.assembly", 3, 30}},
      {"menu.fits", QT_TRANSLATE_NOOP("Menus", "Se&lected fit"), {"menu.assembly", 4, 20}},
      {"menu.joints", QT_TRANSLATE_NOOP("Menus", "Selected j&oint"), {"menu.assembly", 4, 40}},
      {"menu.sequence", QT_TRANSLATE_NOOP("Menus", "S&equence"), {"menu.assembly", 5, 30}},
      {"menu.step", QT_TRANSLATE_NOOP("Menus", "&Step of the sequence"), {"menu.assembly", 5, 40}},
      {"menu.access", QT_TRANSLATE_NOOP("Menus", "&Hand access"), {"menu.assembly", 5, 50}},
      {"menu.places", QT_TRANSLATE_NOOP("Menus", "P&laces"), {"menu.plan", 6, 10}},
      {"menu.plan", QT_TRANSLATE_NOOP("Menus", "P&lan"), {"", 1, 50}},
      {"menu.path", QT_TRANSLATE_NOOP("Menus", "Pat&h"), {"menu.plan", 3, 30}},
      {"menu.paths", QT_TRANSLATE_NOOP("Menus", "K&ept paths"), {"menu.plan", 3, 40}},
      {"menu.difficulty", QT_TRANSLATE_NOOP("Menus", "&Difficulties"), {"menu.plan", 4, 10}},
      {"menu.replay", QT_TRANSLATE_NOOP("Menus", "Repla&y"), {"menu.plan", 5, 10}},
      {"menu.operator", QT_TRANSLATE_NOOP("Menus", "&Operator"), {"menu.plan", 6, 20}},
      {"menu.studies", QT_TRANSLATE_NOOP("Menus", "Stud&ies"), {"menu.plan", 6, 30}},
      {"menu.help", QT_TRANSLATE_NOOP("Menus", "&Help"), {"", 1, 60}},
      {"menu.recent", nullptr, {"menu.file", 1, 30}},
      {"menu.versions", nullptr, {"menu.file", 1, 40}},
      {"menu.named-views", nullptr, {"menu.view", 1, 40}},
  };
  return menus;
}

}  // namespace glissade
