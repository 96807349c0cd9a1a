#pragma once

#include <vector>

#include "engine/environment/rigid_body.h"

namespace glissade {

/// What a row of the legend explains.
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

/// How the thing is drawn in the scene.
enum class LegendMark { Line, Fill, Dot };

struct LegendRow {
  LegendItem item;
  LegendMark mark;
  std::vector<Colour> colours;  ///< from left to right; one where the thing has one colour

  friend bool operator==(const LegendRow& a, const LegendRow& b) { return a.item == b.item; }
};

}  // namespace glissade
