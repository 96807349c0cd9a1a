#pragma once

#include <array>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/sweep/lattice.h"

namespace glissade {

/// Distances from a mesh's surface at the points of a lattice in the body's frame B, in blocks, near the surface only.
class SurfaceDistances {
 public:
  static constexpr int kCells = 4;                    ///< of a block, along each axis
  static constexpr std::size_t kPoints = kCells + 1;  ///< the corners of its cells

  /// Cells of the lattice with the distances of their corners, metres; those beyond the reach are the reach.
  struct Block {
    Vector3 least_B;
    std::array<float, kPoints * kPoints * kPoints> distances;  ///< x slowest, z fastest
  };

  /// Points farther than `reach` from the surface are left out. Unfinished after a stop.
  SurfaceDistances(const TriangleMesh& mesh, double spacing, double reach, const StopToken& stop);

  const std::vector<Block>& blocks() const { return blocks_; }
  double blockSize() const { return kCells * spacing_; }  ///< metres
  double spacing() const { return spacing_; }

  /// Interpolated between the corners of a cell. `at_block`: in cells from the block's least corner, each in
  /// [0, kCells].
  static float interpolated(const Block& block, const Vector3& at_block);

 private:
  double spacing_;
  std::vector<Block> blocks_;
};

}  // namespace glissade
