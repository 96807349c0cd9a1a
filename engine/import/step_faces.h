#pragma once

#include <Poly_Triangulation.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Trsf.hxx>

#include "engine/geometry/surface_face.h"

namespace glissade {

/// What the file states of a face, and how far its triangles are off. Lengths in millimetres. The axis of a
/// plane points to the outer side.
///
/// `deflection` is measured: of planes from the vertices; of cylinders, cones, spheres and tori from the triangles
/// (deviationFrom()); of free surfaces from samples of the surface, which lie at the nodes of a division of each
/// triangle in the surface's parameters. On faces that are not planar the curves between the vertices of the boundary
/// count, too. `mesh` is the triangulation of the face, and `placement` takes its nodes to the shape. Runs in the
/// importing process only.
SurfaceFace measuredFace(const TopoDS_Face& face, const Handle(Poly_Triangulation) & mesh, const gp_Trsf& placement);

}  // namespace glissade
