#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace glissade::oracle {

using Direction = std::array<double, 3>;

/// Two exact solids that overlap in their assembled poses, millimetres, and the straight ways on which the object
/// leaves.
struct OverlapCase {
  struct Solids;

  std::string name;  ///< description for people
  std::shared_ptr<const Solids> solids;
  double accepted = 0.0;   ///< clashes up to this depth are accepted; 0: no clash is accepted
  bool cutsBlock = false;  ///< a person names the block as the body that is cut
  /// Unit vectors: the object meets the block at another place, or the wall of its cut.
  std::vector<Direction> blocked{};
  std::vector<Direction> free{};  ///< unit vectors

  bool leaves() const { return !free.empty(); }
};

/// Overlaps at one place of a plane, a cylinder or a spline with a lip at another place of the same face; rods through
/// plates, with heads or without; bars through frames; discs of a rod's own outline; ends in blocks; sunk flanges.
OverlapCase overlapCase(std::uint64_t seed, std::uint64_t number);

/// STEP files of the object and of the block. Throws std::runtime_error.
void writeCase(const OverlapCase& pair, const std::string& object, const std::string& block);

/// The common volume of the exact solids after the object has moved by `way`, cubic millimetres.
double sharedVolume(const OverlapCase& pair, const Direction& direction, double way);

}  // namespace glissade::oracle
