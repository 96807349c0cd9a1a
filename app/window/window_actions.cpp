#include "app/window/window_actions.h"

#include <iterator>

#include "widgets/workbench/feature_actions.h"

namespace glissade {
namespace {

/// The actions of the window itself.
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
       .tip = QT_TRANSLATE_NOOP("Actions", "Language, theme, font size, unit of lengths, navigation, colours"),
       .place = {"menu.edit", 3, 20},
       .synonyms = QT_TRANSLATE_NOOP("Actions", "options settings")},
      {.id = "view.dark",
       .text = QT_TRANSLATE_NOOP("Actions", "Dark &theme"),
       .key = "Ctrl+D",
       .tip = QT_TRANSLATE_NOOP("Actions", "Light texts on a dark background"),
       .place = {"menu.view", 4, 30},
       .checkable = true},
      {.id = "workspace.assembly",
       .text = QT_TRANSLATE_NOOP("Actions", "&Assembly"),
       .key = "Ctrl+Alt+8",
       .tip = QT_TRANSLATE_NOOP("Actions", "Show the panels for products: their bodies and the sequence"),
       .place = {"menu.panels", 1, 10},
       .synonyms = QT_TRANSLATE_NOOP("Actions", "workspace layout product"),
       .checkable = true},
      {.id = "workspace.planning",
       .text = QT_TRANSLATE_NOOP("Actions", "&Path planning"),
       .key = "Ctrl+Alt+9",
       .tip = QT_TRANSLATE_NOOP("Actions", "Show the panels for one motion: its strategy, its run and its path"),
       .place = {"menu.panels", 1, 20},
       .button = QT_TRANSLATE_NOOP("Actions", "Path planning"),
       .synonyms = QT_TRANSLATE_NOOP("Actions", "workspace layout motion"),
       .checkable = true},
      {.id = "workspace.study",
       .text = QT_TRANSLATE_NOOP("Actions", "&Study"),
       .key = "Ctrl+Alt+0",
       .tip = QT_TRANSLATE_NOOP("Actions", "Show all panels of a run, the bodies and the log, for research"),
       .place = {"menu.panels", 1, 30},
       .synonyms = QT_TRANSLATE_NOOP("Actions", "workspace layout research"),
       .checkable = true},
      {.id = "view.reset-layout",
       .text = QT_TRANSLATE_NOOP("Actions", "&Reset the layout"),
       .tip = QT_TRANSLATE_NOOP("Actions", "Restore the default layout of the panels"),
       .place = {"menu.panels", 2, 10},
       .synonyms = QT_TRANSLATE_NOOP("Actions", "undock dock floating panels windows")},
      {.id = "panel.scene",
       .text = QT_TRANSLATE_NOOP("Actions", "&Bodies panel"),
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

}  // namespace

std::vector<ActionSpec> windowActions() {
  std::vector<ActionSpec> all;
  for (std::vector<ActionSpec> actions :
       {filesActions(), productActions(), arrangeActions(), contactsActions(), placesActions(), runActions(),
        devicesActions(), pathsActions(), sequenceActions(), studiesActions(), viewActions(), sectionActions(),
        measureActions(), headsetActions(), helpActions(), shellActions()}) {
    std::move(actions.begin(), actions.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace glissade
