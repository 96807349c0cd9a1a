#pragma once

#include <vector>

#include "engine/check/product.h"

namespace glissade::check {

/// Numbers of the bodies that touch this one where the product is assembled, ascending. A body without contacts counts
/// as touching all others.
std::vector<std::size_t> touching(const Product& product, std::size_t body);

/// A direction in which a person forbids a body to move.
struct ForbiddenMotion {
  const Body& body;
  Vector3 direction;                ///< any length, world frame
  std::vector<const Body*> beside;  ///< bodies that it touches at the start
};

/// True if the motion keeps out of the direction: until the convex hull of the body is clear of those beside it,
/// neither a piece of the motion nor the displacement from the start is within tolerance::kForbiddenCone of it. `path`:
/// configurations of the body. The motion of a body is that of its bounding box's centre.
bool keepsOut(const ForbiddenMotion& forbidden, const std::vector<Pose>& path);

}  // namespace glissade::check
