#pragma once

#include <optional>
#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// Triangles that cover a polygon, as indices of its corners: a fan where that covers it, else by cutting off ears.
/// The polygon has three corners or more and is nearly plane; corners may coincide. Nothing where its outline crosses
/// itself so that no ear is found. The time is quadratic in the corners of a polygon that a fan does not cover.
std::optional<std::vector<TriangleIndices>> triangulatePolygon(const std::vector<Vector3>& corners);

}  // namespace glissade
