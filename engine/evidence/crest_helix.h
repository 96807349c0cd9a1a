#pragma once

#include <optional>
#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade::evidence {

/// A point about an axis.
struct Around {
  double radius;
  double height;
  double angle;  ///< radians
};

/// Each vertex about an axis. `axis`: unit.
std::vector<Around> aroundOf(const TriangleMesh& mesh, const Vector3& point, const Vector3& axis);

/// The widest gap between angles, radians; a whole turn where there are none.
double widestGap(std::vector<double> angles);

/// The vertices leave no gap about the axis that is wider than a little more than a quarter of a turn.
bool areAround(const std::vector<Around>& vertices);

/// Most starts of a thread, and its largest lead in diameters. A steeper thread does not hold: tan(lead angle) exceeds
/// a friction of 0.4.
inline constexpr int kMostStarts = 6;
inline constexpr double kMostLead = 1.25;

/// The helix of a thread.
struct CrestHelix {
  double lead = 0.0;  ///< metres a turn; below 0: left-handed
  int starts = 1;

  double pitch() const { return lead / starts; }  ///< distance of neighbouring crests along the axis
};

/// Whether the crests are this helix, to three percent: after a turn back by the lead they are on one side of the axis
/// for each start, and on the same sides in the lower and in the upper half of the thread. `crests`: by their heights.
bool areHelix(const std::vector<Around>& crests, const CrestHelix& helix);

/// The helix of this lead that the crests are, with the fewest starts; nothing if they are none. By their heights.
std::optional<CrestHelix> helixOfLead(const std::vector<Around>& crests, double lead);

/// The helix that the crests are, with the fewest starts; nothing if they are none. By their heights. `diameter`: of
/// the wall that they are in, metres. The work does not depend on the number of crests.
std::optional<CrestHelix> helixOf(const std::vector<Around>& crests, double diameter);

}  // namespace glissade::evidence
