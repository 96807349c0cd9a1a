#pragma once

#include <TopoDS_Face.hxx>
#include <cstdint>

namespace glissade {

/// What is wrong with the triangles of a face.
enum class FaceFault : std::uint8_t {
  None,
  NoTriangles,
  OpenBoundary,  ///< the free sides of its triangles are not the polygons of its edges
  Folded,        ///< triangles lie over each other in the parameters of the surface
};

/// Compares the triangles of a face with the polygons of its edges. Quick: no surface is evaluated. Where it finds
/// nothing, the triangles cover the face once. Runs in the importing process only.
FaceFault faultOf(const TopoDS_Face& face);

}  // namespace glissade
