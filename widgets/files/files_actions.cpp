#include "widgets/workbench/feature_actions.h"

namespace glissade {

std::vector<ActionSpec> filesActions() {
  return {
      {.id = "file.new",
       .text = QT_TRANSLATE_NOOP("Actions", "&New from parts..."),
       .key = "Ctrl+N",
       .tip = QT_TRANSLATE_NOOP("Actions", "Make a scenario from STEP, mesh or URDF files, with one moving part"),
       .place = {"menu.file", 1, 10},
       .help = QT_TRANSLATE_NOOP(
           "ActionHelp",
           "STEP files of a product become one row for each part, placed as the assembly has it. Meshes may need a "
           "unit and an axis. One part is the moving part; the others are static or mobile."),
       .synonyms = QT_TRANSLATE_NOOP("Actions", "import STEP CAD mesh")},
      {.id = "file.open",
       .text = QT_TRANSLATE_NOOP("Actions", "&Open..."),
       .key = "Ctrl+O",
       .tip = QT_TRANSLATE_NOOP("Actions",
                                "Open a scenario, a product (STEP, IGES, BREP), part files, or an OMPL.app problem"),
       .place = {"menu.file", 1, 20},
       .button = QT_TRANSLATE_NOOP("Actions", "Open"),
       .help = QT_TRANSLATE_NOOP(
           "ActionHelp",
           "A scenario holds bodies, the moving part, its start and goal, places, fits, kept paths and parameters."),
       .synonyms = QT_TRANSLATE_NOOP("Actions", "load import")},
      {.id = "file.save",
       .text = QT_TRANSLATE_NOOP("Actions", "&Save scenario"),
       .key = "Ctrl+S",
       .tip = QT_TRANSLATE_NOOP("Actions", "Save the scenario with its attributes, strategy and parameters"),
       .place = {"menu.file", 2, 10},
       .button = QT_TRANSLATE_NOOP("Actions", "Save")},
      {.id = "file.save-as",
       .text = QT_TRANSLATE_NOOP("Actions", "Save scenario &as..."),
       .key = "Ctrl+Shift+S",
       .tip = QT_TRANSLATE_NOOP("Actions", "Save the scenario under another name"),
       .place = {"menu.file", 2, 20}},
      {.id = "file.close",
       .text = QT_TRANSLATE_NOOP("Actions", "C&lose"),
       .key = "Ctrl+W",
       .tip = QT_TRANSLATE_NOOP("Actions", "Close the scenario and show the welcome page"),
       .place = {"menu.file", 1, 50}},
      {.id = "file.new-window",
       .text = QT_TRANSLATE_NOOP("Actions", "New &window"),
       .key = "Ctrl+Shift+W",
       .tip = QT_TRANSLATE_NOOP("Actions", "Open another window, for another scenario"),
       .place = {"menu.file", 1, 15}},
      {.id = "recent.forget",
       .text = QT_TRANSLATE_NOOP("Actions", "&Forget the recent files"),
       .tip = QT_TRANSLATE_NOOP("Actions", "Clear the list of recent files")},
  };
}

}  // namespace glissade
