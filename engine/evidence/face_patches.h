#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/evidence/placed_body.h"
#include "engine/evidence/shaft_rings.h"

namespace glissade::evidence {

/// The mesh of a body with finer triangles, and its patches: the parts of faces that another body is below. The surface
/// is that of the body.
struct FacePatches : DividedTriangles {
  static constexpr std::uint32_t kNone = 0xffffffff;

  std::vector<std::uint32_t> patches;  ///< patch of each triangle; kNone: no patch
  std::vector<std::uint32_t> regions;  ///< for each patch, the region of the body

  /// `whole`: the mesh of the body in any frame.
  TriangleMesh divided(const TriangleMesh& whole) const;
};

/// The bodies and depths for which patches are found.
struct PatchQuestion {
  const PlacedBody& body;
  const PlacedBody& other;
  const std::vector<double>& depths;  ///< metres, one entry for each region of the body; 0: the region has no patch
  double above = 0.0;                 ///< metres: the largest height of the other surface above a patch
};

/// A patch is the part of a face where a facing surface of the other body is no deeper than the depth of the region. It
/// extends beyond that part by a 32nd of the diagonal of the box that both bodies share, or by four times the depth if
/// that is more. The wall of a round hole that the other body touches all around is one patch along its whole length,
/// because a hole has one radius. The patch of a shaft in a coaxial hole that touches it all around is a ring along the
/// hole, which extends beyond the hole by five quarters of that.
///
/// Nothing if no region has a depth, or after a stop.
std::optional<FacePatches> facePatchesOf(const PatchQuestion& question, const StopToken& stop);

}  // namespace glissade::evidence
