#include "widgets/workbench/feature_actions.h"

namespace glissade {

std::vector<ActionSpec> studiesActions() {
  return {
      {.id = "study.open",
       .text = QT_TRANSLATE_NOOP("Actions", "&Open study results..."),
       .key = "Ctrl+Shift+O",
       .tip = QT_TRANSLATE_NOOP("Actions",
                                "Write the page of a study with its tables and plots, and open it in the browser"),
       .place = {"menu.studies", 1, 10}},
      {.id = "study.open-run",
       .text = QT_TRANSLATE_NOOP("Actions", "Open ru&n of a study..."),
       .tip = QT_TRANSLATE_NOOP("Actions", "Show a run of a study again, from its file runs/cellN-seedM.json"),
       .place = {"menu.studies", 1, 20}},
      {.id = "study.report-pdf",
       .text = QT_TRANSLATE_NOOP("Actions", "Save the &report as PDF..."),
       .tip = QT_TRANSLATE_NOOP("Actions", "Write the report of the study that is open as PDF"),
       .place = {"menu.studies", 2, 10}},
  };
}

}  // namespace glissade
