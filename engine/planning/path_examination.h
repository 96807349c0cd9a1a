#pragma once

#include <string>
#include <vector>

#include "engine/base/parameters.h"
#include "engine/base/work_watch.h"
#include "engine/planning/path.h"
#include "engine/planning/problem.h"

namespace glissade {

/// States whether the ends of a path are a problem's start and goal, within the metric's rounding.
struct PathEnds {
  bool start = false;
  bool goal = false;
};

/// Precondition: the path is not empty.
PathEnds endsOf(const std::vector<PathPoint>& points, const Problem& problem);

/// An edge of a path that does not keep its demand.
struct BlockedEdge {
  std::size_t edge = 0;     ///< from this configuration to the next
  double at = 0.0;          ///< share of the edge at which the violation was found, in [0, 1]
  NearestObstacle nearest;  ///< nearest points at that place
};

/// Result of checking an existing path against a problem. The path may have been made for another arrangement of the
/// bodies or by another program.
struct PathExamination {
  Path path;  ///< has a complete certificate if the path holds
  PathEnds ends;
  std::vector<BlockedEdge> blocked;  ///< all blocked edges
  bool complete = true;              ///< false after a stop

  bool holds() const { return complete && ends.start && ends.goal && blocked.empty(); }
};

/// Certifies the path edge by edge against the problem's bodies, each edge against its own demand (demandsOf()), and
/// continues after blocked edges. Precondition: the path is not empty, its configurations are valid.
PathExamination examinePath(std::vector<PathPoint> points, const Problem& problem, const ParameterValues& parameters,
                            const WorkWatch& watch = {});

/// Normalizes the quaternions, because files may round them.
std::vector<PathPoint> withUnitRotations(std::vector<PathPoint> points);

}  // namespace glissade
