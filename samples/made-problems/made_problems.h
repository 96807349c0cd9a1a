#pragma once

#include <vector>

#include "samples/made-problems/mazes.h"
#include "samples/made-problems/rooms.h"
#include "samples/made-problems/spirals.h"
#include "samples/made-problems/tubes.h"

namespace glissade::made {

/// All problems, with seeds that were fixed before any problem was planned.
inline std::vector<MadeProblem> madeProblems() {
  return {spiralAmongBars(1),   spiralAmongBars(2),    spiralAmongSpirals(1), spiralInEyelet(50),
          spiralInEyelet(25),   flatMaze(1),           flatMaze(2),           cubicMaze(1),
          cubicMaze(2),         sofaThroughRooms(1),   sofaThroughRooms(2),   tableThroughRooms(1),
          tableThroughRooms(2), blockInTwistedTube(1), blockInTwistedTube(2), rodInTube(1),
          rodInTube(2)};
}

}  // namespace glissade::made
