#include "widgets/workbench/feature_actions.h"

namespace glissade {

std::vector<ActionSpec> helpActions() {
  return {
      {.id = "help.manual",
       .text = QT_TRANSLATE_NOOP("Actions", "&Manual"),
       .key = "F1",
       .tip = QT_TRANSLATE_NOOP("Actions", "Open the manual"),
       .place = {"menu.help", 1, 10}},
      {.id = "help.panel",
       .text = QT_TRANSLATE_NOOP("Actions", "Help on this &panel"),
       .key = "Ctrl+Shift+F1",
       .tip = QT_TRANSLATE_NOOP("Actions", "Open the manual at the panel that has the focus"),
       .place = {"menu.help", 1, 20}},
      {.id = "help.commands",
       .text = QT_TRANSLATE_NOOP("Actions", "&Find a command..."),
       .key = "Ctrl+K",
       .tip = QT_TRANSLATE_NOOP("Actions",
                                "Type a part of its name, or another word for it, to find any command and run it"),
       .place = {"menu.help", 2, 10}},
      {.id = "help.tour",
       .text = QT_TRANSLATE_NOOP("Actions", "&Tour"),
       .tip = QT_TRANSLATE_NOOP("Actions", "Show the first steps in the window: places and strategies, then parts"),
       .place = {"menu.help", 1, 40}},
      {.id = "help.whats-this",
       .text = QT_TRANSLATE_NOOP("Actions", "&What's this?"),
       .key = "Shift+F1",
       .tip = QT_TRANSLATE_NOOP("Actions", "Click anything in the window to read what it is for"),
       .place = {"menu.help", 1, 30}},
      {.id = "help.shortcuts",
       .text = QT_TRANSLATE_NOOP("Actions", "&Keys and shortcuts"),
       .key = "Ctrl+F1",
       .tip = QT_TRANSLATE_NOOP("Actions", "How to steer, and all shortcuts"),
       .place = {"menu.help", 2, 20},
       .synonyms = QT_TRANSLATE_NOOP("Actions", "keyboard keys hotkeys")},
      {.id = "log.copy",
       .text = QT_TRANSLATE_NOOP("Actions", "Copy for a &bug report"),
       .tip = QT_TRANSLATE_NOOP("Actions", "Put versions, scenario, settings and the log into the clipboard"),
       .place = {"menu.help", 3, 10}},
      {.id = "help.change-shortcuts",
       .text = QT_TRANSLATE_NOOP("Actions", "&Change shortcuts..."),
       .tip = QT_TRANSLATE_NOOP("Actions", "Assign other shortcuts to commands"),
       .place = {"menu.edit", 3, 10}},
      {.id = "help.about",
       .text = QT_TRANSLATE_NOOP("Actions", "&About Glissade"),
       .tip = QT_TRANSLATE_NOOP("Actions", "Version, licence and the papers"),
       .place = {"menu.help", 3, 20}},
  };
}

}  // namespace glissade
