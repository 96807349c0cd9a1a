#include "widgets/workbench/feature_actions.h"

namespace glissade {

std::vector<ActionSpec> measureActions() {
  return {
      {.id = "measure.distance",
       .text = QT_TRANSLATE_NOOP("Actions", "Measure a &distance"),
       .key = "Ctrl+L",
       .tip = QT_TRANSLATE_NOOP("Actions", "Click two vertices, edges or faces; the pointer snaps to them"),
       .place = {"menu.measure", 1, 10},
       .synonyms = QT_TRANSLATE_NOOP("Actions", "ruler dimension length"),
       .checkable = true},
      {.id = "measure.angle",
       .text = QT_TRANSLATE_NOOP("Actions", "Measure an &angle"),
       .key = "Ctrl+Shift+L",
       .tip = QT_TRANSLATE_NOOP("Actions", "Click two edges or faces"),
       .place = {"menu.measure", 1, 20},
       .checkable = true},
      {.id = "measure.radius",
       .text = QT_TRANSLATE_NOOP("Actions", "Measure a &radius"),
       .key = "Ctrl+Alt+R",
       .tip = QT_TRANSLATE_NOOP("Actions", "Click a cylindrical face"),
       .place = {"menu.measure", 1, 30},
       .checkable = true},
      {.id = "measure.clearance",
       .text = QT_TRANSLATE_NOOP("Actions", "Measure a &clearance"),
       .key = "Ctrl+Alt+C",
       .tip = QT_TRANSLATE_NOOP("Actions", "Click two bodies: their smallest distance"),
       .place = {"menu.measure", 1, 40},
       .synonyms = QT_TRANSLATE_NOOP("Actions", "gap minimum distance"),
       .checkable = true},
      {.id = "measure.copy",
       .text = QT_TRANSLATE_NOOP("Actions", "Co&py the measurement"),
       .key = "Ctrl+C",
       .tip = QT_TRANSLATE_NOOP("Actions", "Put what was measured into the clipboard, as text"),
       .place = {"menu.measure", 2, 10}},
      {.id = "measure.clear",
       .text = QT_TRANSLATE_NOOP("Actions", "Remove the mea&surement"),
       .tip = QT_TRANSLATE_NOOP("Actions", "Hide what was measured"),
       .place = {"menu.measure", 2, 20}},
  };
}

}  // namespace glissade
