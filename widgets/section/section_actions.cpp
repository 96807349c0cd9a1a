#include "widgets/workbench/feature_actions.h"

namespace glissade {

std::vector<ActionSpec> sectionActions() {
  return {
      {.id = "section.add-x",
       .text = QT_TRANSLATE_NOOP("Actions", "Section across &X"),
       .key = "Ctrl+Alt+X",
       .tip = QT_TRANSLATE_NOOP("Actions", "Cut bodies open across x; drag the arrow to move the section"),
       .place = {"menu.section", 1, 10},
       .synonyms = QT_TRANSLATE_NOOP("Actions", "clip cut cross-section clipping plane")},
      {.id = "section.add-y",
       .text = QT_TRANSLATE_NOOP("Actions", "Section across &Y"),
       .key = "Ctrl+Alt+Y",
       .tip = QT_TRANSLATE_NOOP("Actions", "Cut bodies open across y; drag the arrow to move the section"),
       .place = {"menu.section", 1, 20},
       .synonyms = QT_TRANSLATE_NOOP("Actions", "clip cut cross-section clipping plane")},
      {.id = "section.add-z",
       .text = QT_TRANSLATE_NOOP("Actions", "Section across &Z"),
       .key = "Ctrl+Alt+Z",
       .tip = QT_TRANSLATE_NOOP("Actions", "Cut bodies open across z; drag the arrow to move the section"),
       .place = {"menu.section", 1, 30},
       .synonyms = QT_TRANSLATE_NOOP("Actions", "clip cut cross-section clipping plane")},
      {.id = "section.pick-face",
       .text = QT_TRANSLATE_NOOP("Actions", "Section along a &face"),
       .key = "Ctrl+Alt+A",
       .tip =
           QT_TRANSLATE_NOOP("Actions", "Click a face: the section lies along it, or through the axis of a cylinder"),
       .place = {"menu.section", 1, 40},
       .synonyms = QT_TRANSLATE_NOOP("Actions", "clip cut cross-section clipping plane"),
       .checkable = true},
      {.id = "section.handles",
       .text = QT_TRANSLATE_NOOP("Actions", "&Handles of sections"),
       .tip = QT_TRANSLATE_NOOP("Actions", "Show outlines of sections, and arrows that drag them"),
       .place = {"menu.section", 2, 10},
       .checkable = true,
       .remembered = true},
      {.id = "section.remove-all",
       .text = QT_TRANSLATE_NOOP("Actions", "&Remove all sections"),
       .tip = QT_TRANSLATE_NOOP("Actions", "Draw all bodies whole again"),
       .place = {"menu.section", 2, 20}},
      {.id = "panel.section",
       .text = QT_TRANSLATE_NOOP("Actions", "&Section bar"),
       .key = "Alt+7",
       .tip = QT_TRANSLATE_NOOP("Actions", "Show the bar of the section planes"),
       .place = {"menu.go", 1, 50}},
  };
}

}  // namespace glissade
