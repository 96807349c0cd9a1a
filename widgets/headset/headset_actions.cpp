#include "widgets/workbench/feature_actions.h"

namespace glissade {

std::vector<ActionSpec> headsetActions() {
  return {
      {.id = "view.headset",
       .text = QT_TRANSLATE_NOOP("Actions", "&Show the scene in a headset"),
       .key = "Shift+F11",
       .tip = QT_TRANSLATE_NOOP("Actions", "Show the scene in a headset (OpenXR), or stop it"),
       .place = {"menu.headset", 1, 10},
       .checkable = true},
      {.id = "headset.on-table",
       .text = QT_TRANSLATE_NOOP("Actions", "&Product on a table in the headset"),
       .tip = QT_TRANSLATE_NOOP("Actions",
                                "In the headset the product is as large as a table has room for, or at true scale"),
       .place = {"menu.headset", 1, 20},
       .checkable = true},
      {.id = "headset.to-place",
       .text = QT_TRANSLATE_NOOP("Actions", "Bac&k to the start place"),
       .tip = QT_TRANSLATE_NOOP("Actions", "In the headset, go back to where the scenario was first seen"),
       .place = {"menu.headset", 1, 25}},
      {.id = "headset.panel-in-front",
       .text = QT_TRANSLATE_NOOP("Actions", "Panel &before me in the headset"),
       .tip = QT_TRANSLATE_NOOP("Actions", "The panel in the headset stays before you, or goes with the other hand"),
       .place = {"menu.headset", 1, 30},
       .checkable = true},
      {.id = "headset.section",
       .text = QT_TRANSLATE_NOOP("Actions", "Se&ction at the hand"),
       .tip = QT_TRANSLATE_NOOP("Actions",
                                "Cut bodies open where a controller of the headset is; the section follows the hand "
                                "while its button is held"),
       .place = {"menu.headset", 2, 10}},
      {.id = "headset.measure",
       .text = QT_TRANSLATE_NOOP("Actions", "&Measure with the ray"),
       .tip = QT_TRANSLATE_NOOP(
           "Actions",
           "Take the point that the ray of a controller meets; the second one is measured from the first one"),
       .place = {"menu.headset", 2, 20}},
      {.id = "headset.select",
       .text = QT_TRANSLATE_NOOP("Actions", "S&elect with the ray"),
       .tip = QT_TRANSLATE_NOOP("Actions", "Select the body that the ray of a controller meets"),
       .place = {"menu.headset", 2, 25}},
      {.id = "headset.instruction",
       .text = QT_TRANSLATE_NOOP("Actions", "&Walk through the instruction"),
       .tip = QT_TRANSLATE_NOOP("Actions",
                                "In the headset: take the part that is marked and lead it along its motion to where it "
                                "belongs, step by step"),
       .place = {"menu.headset", 2, 30},
       .checkable = true},
      {.id = "headset.left-handed",
       .text = QT_TRANSLATE_NOOP("Actions", "&Left hand takes the object"),
       .tip = QT_TRANSLATE_NOOP("Actions", "In the headset the left controller takes the object, or the right one"),
       .place = {"menu.headset", 3, 10},
       .checkable = true},
      {.id = "headset.grip-alpha",
       .text = QT_TRANSLATE_NOOP("Actions", "&Grip sets the computer's share"),
       .tip = QT_TRANSLATE_NOOP("Actions",
                                "The firmer a controller holds the object, the smaller α is; let go, α is as before"),
       .place = {"menu.headset", 3, 20},
       .checkable = true},
      {.id = "headset.leave",
       .text = QT_TRANSLATE_NOOP("Actions", "Lea&ve the headset"),
       .tip = QT_TRANSLATE_NOOP("Actions", "Stop showing the scene in the headset"),
       .place = {"menu.headset", 1, 40}},
      {.id = "headset.figures",
       .text = QT_TRANSLATE_NOOP("Actions", "&Figures of drawing in the headset"),
       .tip =
           QT_TRANSLATE_NOOP("Actions", "Say what a picture of the headset costs, and how simple the scene is for it"),
       .place = {"menu.headset", 4, 10}},
  };
}

}  // namespace glissade
