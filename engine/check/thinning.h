#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade::check {

/// Of the thickness below a face: what a body that is taken thinner may lose there, and what a hook that bends may.
inline constexpr double kThicknessShare = 0.2;
inline constexpr double kHookShare = 0.45;

/// The judge's own construction of a body that is taken thinner, face by face. Slow and simple.
///
/// A vertex moves to where the planes of its faces, each moved inwards by its target, meet: the least squares' solution
/// with the faces' angles as weights. The target of a face is its allowance, or a fifth of the thickness below it where
/// that is less. Where a face would move outwards, the vertex moves against the mean of the normals instead, by the
/// largest allowance at it. The move is shortened so that no face moves farther than the largest allowance at the
/// vertex or its fifth, and the vertex by no more than two of these allowances; where a face moves outwards still, it
/// stays.
///
/// Where the surface is open, it has an inside far from its open edges only (open_surface.h).
///
/// `share`: instead of a fifth of the thickness, as AllowanceBound::share.
///
/// `allowances`: of each triangle, metres, >= 0. The mesh itself where the body cannot be thinned so, or is open too
/// near to a face with an allowance.
TriangleMesh thinned(const TriangleMesh& mesh, const std::vector<double>& allowances, double share = kThicknessShare);

}  // namespace glissade::check
