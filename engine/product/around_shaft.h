#pragma once

#include <optional>
#include <vector>

#include "engine/product/fastener_shape.h"

namespace glissade {

/// What of a body is around a shaft, or in its way. Heights along the axis of the shaft, metres.
struct AroundShaft {
  std::size_t body = 0;
  double low = 0.0;
  double high = 0.0;
  double hole = 0.0;       ///< radius of its narrowest hole; 0: solid
  double tight = 0.0;      ///< metres of the axis in which the hole is narrower by a thread, or the body solid
  double equal = 0.0;      ///< in which the hole is as wide as the shaft, or narrower by less
  double surround = 0.0;   ///< in which it is around the shaft at all
  double solid = 0.0;      ///< in which it is solid
  double tightHigh = 0.0;  ///< upper end of what is tight or equal
  double tightLow = 0.0;
  /// It is drawn as if the shaft were not there.
  bool hasNoHole() const { return solid > 0.95 * surround; }

  bool isBlind = false;  ///< its hole ends near the lower end of the shaft
};

/// Below the head of a screw, along its shaft. Holes that are wider than this many radii of the shaft do not count.
inline constexpr double kAroundReach = 2.2;

/// Nothing where the body is not around the shaft. `axis`: in the body's frame.
std::optional<AroundShaft> aroundShaft(const AxialMesh& body, const AxisLine& axis, const TurnedShape& shaft);

}  // namespace glissade
