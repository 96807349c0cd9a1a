#include "widgets/workbench/feature_actions.h"

namespace glissade {

std::vector<ActionSpec> devicesActions() {
  return {
      {.id = "operator.camera",
       .text = QT_TRANSLATE_NOOP("Actions", "Steer the &camera"),
       .key = "F3",
       .tip = QT_TRANSLATE_NOOP("Actions", "Keys, 6D mouse and gamepad move the camera, or the object again"),
       .place = {"menu.operator", 1, 10},
       .help = QT_TRANSLATE_NOOP(
           "ActionHelp",
           "Keys and devices move the object as a rule. In camera mode the same input moves the view instead."),
       .checkable = true},
      {.id = "operator.camera-roll",
       .text = QT_TRANSLATE_NOOP("Actions", "Let the camera &roll"),
       .key = "Shift+F3",
       .tip =
           QT_TRANSLATE_NOOP("Actions", "Turning about the line of sight rolls the camera, or the horizon stays level"),
       .place = {"menu.operator", 1, 20},
       .checkable = true},
      {.id = "operator.frame",
       .text = QT_TRANSLATE_NOOP("Actions", "Change steering &axes"),
       .key = "Shift+F2",
       .tip = QT_TRANSLATE_NOOP("Actions", "Move along the axes of the view, of the world or of the object"),
       .place = {"menu.operator", 1, 30},
       .help = QT_TRANSLATE_NOOP("ActionHelp", "It holds for keys and devices. F over the scene does the same.")},
      {.id = "operator.devices",
       .text = QT_TRANSLATE_NOOP("Actions", "Calibrate the &devices..."),
       .key = "F4",
       .tip = QT_TRANSLATE_NOOP("Actions", "Calibrate 6D mouse, keys and gamepad: live axes, curves, presets, buttons"),
       .place = {"menu.operator", 2, 10}},
      {.id = "operator.head",
       .text = QT_TRANSLATE_NOOP("Actions", "&Follow the head"),
       .key = "Ctrl+F3",
       .tip = QT_TRANSLATE_NOOP("Actions", "The view follows a head that a tracker (OpenTrack) sees before the screen"),
       .place = {"menu.operator", 1, 40},
       .checkable = true},
      {.id = "operator.head-page",
       .text = QT_TRANSLATE_NOOP("Actions", "Calibrate the &head tracker..."),
       .key = "Shift+F4",
       .tip = QT_TRANSLATE_NOOP("Actions", "Port, axes, signs, rest and delay of the head tracker, with live values"),
       .place = {"menu.operator", 2, 20}},
  };
}

}  // namespace glissade
