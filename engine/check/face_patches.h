#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/check/placed_body.h"
#include "engine/check/shaft_rings.h"

namespace glissade::check {

/// The mesh of a body with finer triangles, and which of them are of patches: parts of faces that another body is
/// below. The surface is the same.
struct FacePatches : DividedTriangles {
  static constexpr std::uint32_t kNone = 0xffffffff;

  std::vector<std::uint32_t> patches;  ///< patch of each triangle; kNone: of none
  std::vector<std::uint32_t> regions;  ///< of the body, of each patch

  /// `whole`: the mesh of the body in any frame.
  TriangleMesh divided(const TriangleMesh& whole) const;
};

/// A question about the patches of a body.
struct PatchQuestion {
  const PlacedBody& body;
  const PlacedBody& other;
  const std::vector<double>& depths;  ///< metres, of each region of the body: 0 where it has no patch
  double above = 0.0;                 ///< metres: the other surface may be so far above a patch
};

/// A patch is where a surface of the other body that faces the face is no deeper below it than the depth of the region.
/// It reaches beside that by a 32nd of the box that both bodies have in common, or by four times the depth where that
/// is more. The wall of a round hole that the other body is in all around is one patch along its whole length, because
/// a hole has one radius. Where a shaft is all around in a coaxial hole, its patch is a ring as long as the hole, and
/// reaches beside it by five quarters of that.
///
/// Nothing where no region has a depth, or after a stop.
std::optional<FacePatches> facePatchesOf(const PatchQuestion& question, const StopToken& stop);

}  // namespace glissade::check
