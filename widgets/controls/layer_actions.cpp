#include "widgets/controls/layer_actions.h"

namespace glissade {

const std::vector<ActionSpec>& layerActionSpecs() {
  static const std::vector<ActionSpec> specs{
      {"layer.bodies", QT_TRANSLATE_NOOP("Actions", "&Obstacles"), "",
       QT_TRANSLATE_NOOP("Actions", "Show the obstacles"), true},
      {"layer.object", QT_TRANSLATE_NOOP("Actions", "O&bject"), "", QT_TRANSLATE_NOOP("Actions", "Show the object"),
       true},
      {"layer.ends", QT_TRANSLATE_NOOP("Actions", "Start and &goal"), "",
       QT_TRANSLATE_NOOP("Actions", "Show start and goal as ghosts"), true},
      {"layer.workspace", QT_TRANSLATE_NOOP("Actions", "&Workspace"), "",
       QT_TRANSLATE_NOOP("Actions", "Show the bounds of the reference point"), true},
      {"layer.roadmap", QT_TRANSLATE_NOOP("Actions", "&Roadmap"), "", QT_TRANSLATE_NOOP("Actions", "Show the trees"),
       true},
      {"layer.path", QT_TRANSLATE_NOOP("Actions", "&Path"), "", QT_TRANSLATE_NOOP("Actions", "Show the path"), true},
      {"layer.contact", QT_TRANSLATE_NOOP("Actions", "&Contact"), "",
       QT_TRANSLATE_NOOP("Actions", "Show the nearest obstacle and the tangent plane"), true},
      {"layer.force", QT_TRANSLATE_NOOP("Actions", "Guidance &force"), "",
       QT_TRANSLATE_NOOP("Actions", "Show what guides the hand: the force as an arrow, its strength as a tint"), true},
      {"layer.grid", QT_TRANSLATE_NOOP("Actions", "Grou&nd grid"), "Ctrl+Shift+6",
       QT_TRANSLATE_NOOP("Actions", "Show a grid under the product, in round lengths of the unit in use"), true},
      {"layer.legend", QT_TRANSLATE_NOOP("Actions", "&Legend"), "Ctrl+Shift+7",
       QT_TRANSLATE_NOOP("Actions", "Say what the colours in the scene mean: a row for each thing that is drawn now"),
       true},
      {"layer.free-cells", QT_TRANSLATE_NOOP("Actions", "&Free cells"), "",
       QT_TRANSLATE_NOOP("Actions", "Show the octree's free cells, the coarsest first"), true},
      {"layer.mobile-cells", QT_TRANSLATE_NOOP("Actions", "&Cells with mobile bodies"), "",
       QT_TRANSLATE_NOOP("Actions", "Show the cells that only mobile bodies clutter"), true},
      {"layer.static-cells", QT_TRANSLATE_NOOP("Actions", "Cells with s&tatic bodies"), "",
       QT_TRANSLATE_NOOP("Actions", "Show the cells that static bodies clutter"), true},
      {"layer.places", QT_TRANSLATE_NOOP("Actions", "&Places"), "F8",
       QT_TRANSLATE_NOOP("Actions", "Show the places, coloured by complexity; click to select"), true},
      {"layer.borders", QT_TRANSLATE_NOOP("Actions", "&Borders"), "",
       QT_TRANSLATE_NOOP("Actions", "Show where places meet"), true},
      {"layer.graph", QT_TRANSLATE_NOOP("Actions", "Topological &graph"), "F9",
       QT_TRANSLATE_NOOP("Actions", "Show the topological graph with its costs"), true},
      {"layer.coarse-path", QT_TRANSLATE_NOOP("Actions", "Coarse pat&h"), "",
       QT_TRANSLATE_NOOP("Actions", "Show the cheapest way through the graph"), true},
      {"layer.milestones", QT_TRANSLATE_NOOP("Actions", "&Milestones"), "",
       QT_TRANSLATE_NOOP("Actions",
                         "Show the configurations to pass through; drag one to move it, Ctrl+drag to turn it"),
       true},
      {"layer.region", QT_TRANSLATE_NOOP("Actions", "&Region of a step"), "",
       QT_TRANSLATE_NOOP("Actions", "Show where the local planner of the chosen step searches"), true},
      {"layer.difficulty", QT_TRANSLATE_NOOP("Actions", "Why there i&s no path"), "",
       QT_TRANSLATE_NOOP("Actions", "Show why no path was found: blocking body, gap, way of least penetration"), true},
      {"layer.keys", QT_TRANSLATE_NOOP("Actions", "Ke&ys of steering"), "",
       QT_TRANSLATE_NOOP("Actions", "Write the keys of steering over the scene while a run goes on by hand"), true},
      {"layer.help", QT_TRANSLATE_NOOP("Actions", "Where your &hand helps"), "",
       QT_TRANSLATE_NOOP("Actions", "Show the places where your hand helps the search, and the arrow that leads there"),
       true}};
  return specs;
}

}  // namespace glissade
