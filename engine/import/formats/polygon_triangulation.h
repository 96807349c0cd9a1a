#pragma once

#include <optional>
#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// Triangles that cover a polygon, as indices of its corners: a fan if it covers the polygon, else by cutting off ears.
/// Precondition: three or more corners, nearly in a plane; corners may coincide. Nothing if the outline crosses itself
/// so that no ear is found. The time is quadratic in the corners of a polygon without a fan.
std::optional<std::vector<TriangleIndices>> triangulatePolygon(const std::vector<Vector3>& corners);

}  // namespace glissade
