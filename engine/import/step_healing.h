#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

#include "engine/import/step_face_check.h"
#include "engine/import/step_face_mesher.h"

namespace glissade {

/// A face whose triangles were wrong.
struct HealedFace {
  TopoDS_Face face;
  FaceFault fault = FaceFault::None;                ///< that it had
  FaceMeshing meshing = FaceMeshing::Failed;        ///< that replaced its triangles
};

/// Looks at the triangles of each face of a meshed shape and makes those anew that are wrong, so that they fit those of
/// the neighbours. In the order of the faces. Runs in the importing process only.
std::vector<HealedFace> healFaces(const TopoDS_Shape& meshed, double deflection);

}  // namespace glissade
