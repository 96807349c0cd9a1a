#pragma once

#include <optional>
#include <vector>

#include "engine/fits/fastener_shape.h"

namespace glissade {

/// The part of a body around a shaft, or in its way. Heights along the axis of the shaft, metres.
struct AroundShaft {
  std::size_t body = 0;
  double low = 0.0;
  double high = 0.0;
  double hole = 0.0;       ///< radius of its narrowest hole; 0: the body is solid
  double tight = 0.0;      ///< length in which the hole is narrower by a thread, or the body solid, metres
  double threaded = 0.0;   ///< length of `tight` in which the hole is no narrower than the core of a thread
  double equal = 0.0;      ///< length in which the hole is as wide as the shaft, or narrower by less than a thread
  double surround = 0.0;   ///< length in which it surrounds the shaft
  double solid = 0.0;      ///< length in which it is solid
  double tightHigh = 0.0;  ///< ends of the tight or equal part
  double tightLow = 0.0;
  /// True if it is drawn as if the shaft were not there.
  bool hasNoHole() const { return solid > 0.95 * surround; }

  bool isBlind = false;  ///< its hole ends near the lower end of the shaft
};

/// Holes below the head of a screw that are wider than this, in radii of the shaft, do not count.
inline constexpr double kAroundReach = 2.2;

/// Nothing if the body is not around the shaft. `axis`: in the body's frame.
std::optional<AroundShaft> aroundShaft(const AxialMesh& body, const AxisLine& axis, const TurnedShape& shaft);

}  // namespace glissade
