#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/check/placed_body.h"

namespace glissade::check {

/// Convex, its corners in the order of its triangle.
using Polygon = std::vector<Vector3>;

/// On which side of another body's surface a piece is. `On`: within ten nanometres of the surface.
enum class Side { Inside, Outside, On };

/// A piece of a body's surface that crosses the surface of the other body nowhere.
struct CutPiece {
  Polygon polygon;
  std::uint32_t triangle = 0;  ///< of the body
  Side side = Side::Outside;   ///< of the other body
};

Vector3 middleOf(const Polygon& polygon);

/// Cuts the triangles of the body where they meet the surface of the other body, and gives each piece to `take`.
/// Whether all pieces were given: not where they are too many, nor after a stop. Both surfaces are closed.
bool cutSurface(const PlacedBody& body, const PlacedBody& other, const std::function<void(const CutPiece&)>& take,
                const StopToken& stop);

}  // namespace glissade::check
