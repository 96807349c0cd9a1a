#pragma once

#include <cstdint>
#include <string>

#include "tests/oracle/ring_solid.h"

namespace glissade::oracle {

/// A body in a block, millimetres. The body can leave upwards only, where the block may have a lip over it.
struct TrappedPair {
  std::string name;  ///< description for people
  std::vector<Ring> object;
  std::vector<Ring> block;
  bool round = false;  ///< true: the corners approximate circles, and STEP files of the pair have circles
  double lip = 0.0;    ///< overlap of the lip over the body; 0: no lip, and the body leaves
  double fit = 0.0;    ///< overlap at another place of the pair
  double top = 0.0;    ///< height of the block's top
  /// Ratio of a corner's distance from the other body's surface to that of its faces, if these are inside that body:
  /// the nearest point of the surface to a corner may be a corner.
  double corner = 1.0;

  bool isTrapped() const { return lip > 0.0; }
};

/// Prisms, knobs, dovetails, gears and inserts; of four pairs three are trapped. Lips range from 1 % of the radius down
/// to 0.02 % of it plus `leastLip` millimetres.
TrappedPair trappedPair(std::uint64_t seed, std::uint64_t number, double leastLip);

}  // namespace glissade::oracle
