#pragma once

#include <vector>

#include "engine/places/rigid_body.h"

namespace glissade {

/// The kinds of things that rows of the legend explain.
enum class LegendItem {
  Object,
  Start,
  Goal,
  Workspace,
  StartTree,
  GoalTree,
  OperatorNodes,
  ContactNodes,
  Path,
  PathByClearance,
  PathByStep,
  PathOfComputer,
  PathOfOperator,
  PathOfContact,
  ObjectOnPath,
  RefusedPath,
  Blocked,
  Nearest,
  Contact,
  Guidance,
  Hand,
  Sweep,
  FreeCells,
  MobileCells,
  StaticCells,
  Places,
  ClutteredPlaces,
  Borders,
  Graph,
  CoarsePath,
  Milestones,
  Region,
  InTheWay,
  TightestPlace,
  TreeGap,
  Help,
  Overlap,
  RefusedEnd,
  ForbiddenDirection,
  Selected,
  MovingPart,
  WayOfPart,
  Reach,
  ReachBlocked
};

/// The mark of a thing in the legend, as it is drawn in the scene.
enum class LegendMark { Line, Fill, Dot };

struct LegendRow {
  LegendItem item;
  LegendMark mark;
  std::vector<Colour> colours;  ///< from left to right; one colour if the thing has one

  friend bool operator==(const LegendRow& a, const LegendRow& b) { return a.item == b.item; }
};

}  // namespace glissade
