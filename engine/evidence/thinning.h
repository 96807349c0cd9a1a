#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade::evidence {

/// Largest share of the thickness below a face that a thinned body may lose there, that the wall of a tapped hole may
/// (the thread of an M5 takes 0.21 of the wall of its nut), and that a bending hook may.
inline constexpr double kThicknessShare = 0.2;
inline constexpr double kThreadShare = 0.3;
inline constexpr double kHookShare = 0.45;

/// Thins a body face by face, independently of the planners. Slow and simple.
///
/// A vertex moves to the intersection of the planes of its faces, each moved inwards by its target: the least squares'
/// solution with the faces' angles as weights. The target of a face is its allowance, or a fifth of the thickness below
/// it if that is less. If a face would move outwards, or the vertex by more than twice its largest allowance, it moves
/// against the normals of the faces with an allowance instead, as far as these require; if that moves a face outwards,
/// too, against the mean of all normals, by the largest allowance at it. The move is shortened so that no face moves
/// farther than the largest allowance at the vertex or its fifth, and the vertex by no more than twice this allowance.
/// If a face still moves outwards, the vertex stays.
///
/// An open surface has an inside only far from its open edges (open_surface.h).
///
/// `share`: replaces a fifth of the thickness, see AllowanceBound::share.
///
/// `allowances`: one entry for each triangle, metres, >= 0. Returns the mesh itself if the body cannot be thinned, or
/// is open too near to a face with an allowance.
TriangleMesh thinned(const TriangleMesh& mesh, const std::vector<double>& allowances, double share = kThicknessShare);

}  // namespace glissade::evidence
