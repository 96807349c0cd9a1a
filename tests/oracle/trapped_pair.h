#pragma once

#include <cstdint>
#include <string>

#include "tests/oracle/ring_solid.h"

namespace glissade::oracle {

/// A body in a block, millimetres. The body can leave upwards only, and a lip of the block is over it, or none is.
struct TrappedPair {
  std::string name;  ///< what it is, for people
  std::vector<Ring> object;
  std::vector<Ring> block;
  bool round = false;  ///< corners stand for circles: STEP files hold these
  double lip = 0.0;    ///< by how much the lip is over the body; 0: there is none, the body leaves
  double fit = 0.0;    ///< by how much another place of the pair overlaps
  double top = 0.0;    ///< of the block
  /// How much farther a corner is from the other body's surface than the faces at it, where these are in it: the
  /// surface that is nearest to a corner may be a corner.
  double corner = 1.0;

  bool isTrapped() const { return lip > 0.0; }
};

/// Prisms, knobs, dovetails, gears and inserts; of four pairs three are trapped. Lips are from 1 % of the radius down
/// to `leastShare` of it and the given number of millimetres.
TrappedPair trappedPair(std::uint64_t seed, std::uint64_t number, double leastLip);

}  // namespace glissade::oracle
