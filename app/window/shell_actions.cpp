#include "app/window/shell_actions.h"

namespace glissade {

std::vector<ActionSpec> shellActions() {
  return {
      {.id = "file.quit",
       .text = QT_TRANSLATE_NOOP("Actions", "&Quit"),
       .key = "Ctrl+Q",
       .tip = QT_TRANSLATE_NOOP("Actions", "Quit Glissade"),
       .place = {"menu.file", 5, 10}},
      {.id = "edit.context-menu",
       .text = QT_TRANSLATE_NOOP("Actions", "Open the context &menu"),
       .key = "Shift+F10",
       .tip = QT_TRANSLATE_NOOP("Actions", "Open the menu of what is selected in the scene or in the table in use"),
       .place = {"menu.edit", 2, 10}},
      {.id = "edit.preferences",
       .text = QT_TRANSLATE_NOOP("Actions", "&Preferences..."),
       .key = "Ctrl+,",
       .tip = QT_TRANSLATE_NOOP("Actions", "Language, theme, size of texts, unit of lengths, navigation, colours"),
       .place = {"menu.edit", 3, 20}},
      {.id = "view.dark",
       .text = QT_TRANSLATE_NOOP("Actions", "Dark &theme"),
       .key = "Ctrl+D",
       .tip = QT_TRANSLATE_NOOP("Actions", "Light texts on a dark background"),
       .place = {"menu.view", 4, 30},
       .checkable = true},
      {.id = "view.reset-layout",
       .text = QT_TRANSLATE_NOOP("Actions", "&Reset the layout"),
       .tip = QT_TRANSLATE_NOOP("Actions", "Put all panels where they were at first"),
       .place = {"menu.panels", 1, 10}},
      {.id = "panel.scene",
       .text = QT_TRANSLATE_NOOP("Actions", "S&cene panel"),
       .key = "Alt+1",
       .tip = QT_TRANSLATE_NOOP("Actions", "Bring the list of bodies to the front"),
       .place = {"menu.go", 1, 10}},
      {.id = "panel.log",
       .text = QT_TRANSLATE_NOOP("Actions", "&Log panel"),
       .key = "Ctrl+Alt+L",
       .tip = QT_TRANSLATE_NOOP("Actions", "Bring the log of messages to the front"),
       .place = {"menu.go", 2, 70}},
  };
}

}  // namespace glissade
