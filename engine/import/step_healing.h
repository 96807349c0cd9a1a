#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

#include "engine/import/step_face_check.h"
#include "engine/import/step_face_mesher.h"
#include "engine/import/step_fineness.h"

namespace glissade {

/// A face whose triangles were wrong.
struct HealedFace {
  TopoDS_Face face;
  FaceFault fault = FaceFault::None;          ///< that it had
  FaceMeshing meshing = FaceMeshing::Failed;  ///< that replaced its triangles
  double deflection = 0.0;                    ///< of the new triangles, measured
};

/// Looks at the triangles of each face of a meshed shape and makes those anew that are wrong, so that they fit those of
/// the neighbours. In the order of the faces; `deflection` is in millimetres.
std::vector<HealedFace> healFaces(const TopoDS_Shape& meshed, double deflection);

/// Meshes a shape and heals its faces. Where boundaries of a face cross each other as polygons, the whole shape is
/// meshed finer, up to a quarter of the deflection, and as it was asked for if that does not help. Runs in the
/// importing process only.
std::vector<HealedFace> meshAndHeal(const TopoDS_Shape& shape, const Fineness& fineness);

}  // namespace glissade
