#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

#include "engine/import/step_face_check.h"
#include "engine/import/step_face_mesher.h"
#include "engine/import/step_fineness.h"

namespace glissade {

/// A face whose triangles had a fault.
struct HealedFace {
  TopoDS_Face face;
  FaceFault fault = FaceFault::None;
  FaceMeshing meshing = FaceMeshing::Failed;  ///< the way in which its triangles were replaced
  double deflection = 0.0;                    ///< measured deflection of the new triangles
};

/// Examines the triangles of each face of a meshed shape and replaces faulty ones so that they match those of the
/// neighbours. The result is in the order of the faces; `deflection` is in millimetres.
std::vector<HealedFace> healFaces(const TopoDS_Shape& meshed, double deflection);

/// Meshes a shape and heals its faces. If boundaries of a face cross each other as polygons, the whole shape is meshed
/// finer, up to a quarter of the deflection, and with the requested deflection if that does not help. Runs in the
/// importing process only.
std::vector<HealedFace> meshAndHeal(const TopoDS_Shape& shape, const Fineness& fineness);

}  // namespace glissade
