#pragma once

#include <Poly_Triangulation.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Trsf.hxx>

#include "engine/geometry/surface_face.h"

namespace glissade {

/// The surface that the file states for a face, and the deflection of its triangles. Lengths in millimetres. The axis
/// of a plane points outwards.
///
/// `deflection` is measured: for planes from the vertices; for cylinders, cones, spheres and tori from the triangles
/// (deviationFrom()); for free surfaces from samples at a division of each triangle in the surface's parameters. On
/// faces that are not planar, the curves between the vertices of the boundary also count. `mesh` is the triangulation
/// of the face, and `placement` transforms its nodes to the shape. Runs in the importing process only.
SurfaceFace measuredFace(const TopoDS_Face& face, const Handle(Poly_Triangulation) & mesh, const gp_Trsf& placement);

}  // namespace glissade
