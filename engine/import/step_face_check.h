#pragma once

#include <TopoDS_Face.hxx>
#include <cstdint>

namespace glissade {

/// A fault in the triangles of a face.
enum class FaceFault : std::uint8_t {
  None,
  NoTriangles,
  OpenBoundary,  ///< the free sides of its triangles differ from the polygons of its edges
  Folded,        ///< triangles overlap in the parameters of the surface
  Wound,         ///< a boundary goes around the surface and encloses nothing, and the triangles are off the surface
};

/// Compares the triangles of a face with the polygons of its edges. Quick: no surface is evaluated. Without a fault,
/// the triangles cover the face once, except where a boundary is wound. Runs in the importing process only.
FaceFault faultOf(const TopoDS_Face& face);

/// True if the parameters of a boundary jump by more than half of a turn from one edge to the next.
bool isWound(const TopoDS_Face& face);

}  // namespace glissade
