#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/evidence/placed_body.h"

namespace glissade::evidence {

/// A convex polygon; its corners are oriented like its triangle.
using Polygon = std::vector<Vector3>;

/// Side of another body's surface on which a piece is. `On`: within ten nanometres of the surface.
enum class Side { Inside, Outside, On };

/// A piece of a body's surface that does not cross the surface of the other body.
struct CutPiece {
  Polygon polygon;
  std::uint32_t triangle = 0;  ///< triangle of the body
  Side side = Side::Outside;   ///< side of the other body's surface
};

Vector3 middleOf(const Polygon& polygon);

/// Cuts the triangles of the body where they meet the surface of the other body, and passes each piece to `take`. True
/// if all pieces were passed; false if there are too many, or after a stop. Precondition: both surfaces are closed.
bool cutSurface(const PlacedBody& body, const PlacedBody& other, const std::function<void(const CutPiece&)>& take,
                const StopToken& stop);

}  // namespace glissade::evidence
