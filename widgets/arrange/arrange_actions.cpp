#include "widgets/workbench/feature_actions.h"

namespace glissade {

std::vector<ActionSpec> arrangeActions() {
  return {
      {.id = "assembly.arrange",
       .text = QT_TRANSLATE_NOOP("Actions", "Arra&nge with the mouse"),
       .key = "Ctrl+G",
       .tip = QT_TRANSLATE_NOOP(
           "Actions",
           "Move and turn bodies, start and goal in the view: by arrows, rings, the arrow keys, or the body itself"),
       .place = {"menu.assembly", 3, 10},
       .synonyms = QT_TRANSLATE_NOOP("Actions", "move rotate drag transform"),
       .checkable = true},
      {.id = "assembly.align",
       .text = QT_TRANSLATE_NOOP("Actions", "&Align..."),
       .key = "Ctrl+Shift+G",
       .tip = QT_TRANSLATE_NOOP("Actions",
                                "Put a vertex, an edge, an axis or a plane onto one of another body: click that of the "
                                "moving part, then the other"),
       .place = {"menu.placement", 1, 10},
       .button = QT_TRANSLATE_NOOP("Actions", "Align"),
       .synonyms = QT_TRANSLATE_NOOP("Actions", "mate constraint coincident concentric"),
       .checkable = true},
      {.id = "assembly.flip",
       .text = QT_TRANSLATE_NOOP("Actions", "Flip the ali&gnment"),
       .key = "Ctrl+Shift+F",
       .tip = QT_TRANSLATE_NOOP("Actions",
                                "Turn what was aligned last round: the axis, or the face, looks the other way; a "
                                "cylinder goes to the other side of the plane"),
       .place = {"menu.placement", 1, 20},
       .button = QT_TRANSLATE_NOOP("Actions", "Flip")},
      {.id = "assembly.snap",
       .text = QT_TRANSLATE_NOOP("Actions", "&Snap to steps"),
       .key = "Ctrl+Shift+K",
       .tip = QT_TRANSLATE_NOOP("Actions",
                                "Let the arrows and rings of arranging move by whole steps; Ctrl held suspends it"),
       .place = {"menu.placement", 1, 40},
       .button = QT_TRANSLATE_NOOP("Actions", "Snap"),
       .checkable = true},
      {.id = "assembly.snap-features",
       .text = QT_TRANSLATE_NOOP("Actions", "Snap &to faces and axes"),
       .key = "Ctrl+Shift+T",
       .tip = QT_TRANSLATE_NOOP(
           "Actions",
           "Let what is dragged by an arrow or a square meet faces and axes of other bodies; Ctrl held suspends it"),
       .place = {"menu.placement", 1, 50},
       .checkable = true},
      {.id = "assembly.pick-frame",
       .text = QT_TRANSLATE_NOOP("Actions", "&Place by a face or axis"),
       .tip = QT_TRANSLATE_NOOP("Actions",
                                "Click a plane or a cylinder: the numbers of the placement are those of its frame"),
       .place = {"menu.placement", 1, 30},
       .checkable = true},
      {.id = "assembly.fit-workspace",
       .text = QT_TRANSLATE_NOOP("Actions", "&Fit the workspace"),
       .tip = QT_TRANSLATE_NOOP("Actions", "Fit the workspace to all bodies, with room to remove the object"),
       .place = {"menu.placement", 2, 10},
       .synonyms = QT_TRANSLATE_NOOP("Actions", "bounding box limits")},
  };
}

}  // namespace glissade
