#pragma once

#include <TopoDS_Shape.hxx>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/import/import_protocol.h"
#include "engine/import/step_face_entities.h"
#include "engine/import/step_healing.h"
#include "engine/import/step_tessellated.h"

namespace glissade {

/// A shape as triangles that are counter-clockwise from outside; each face has its vertices. Vertices that faces share
/// along an edge are equal bit by bit.
struct StepTriangles {
  import_protocol::Shape record;
  std::vector<double> vertices;  ///< x y z, millimetres
  std::vector<std::uint32_t> indices;
  std::vector<import_protocol::Face> faces;  ///< faces in the order of the triangles
  std::vector<std::string> entities;         ///< names of the faces' entities, in the order of `faces`
  std::vector<HealedFace> healed;            ///< faces whose triangles had a fault
  /// For a solid with healed faces: the volumes of its triangles and of its faces differ by more than the deflection
  /// times the area.
  bool volumeDiffers = false;
  double volume = 0.0;       ///< volume of the triangles, cubic millimetres; set if `volumeDiffers`
  double exactVolume = 0.0;  ///< volume of the faces, cubic millimetres; set if `volumeDiffers`
};

/// Triangles of the shape, scaled by `scale` and mirrored in x on request, within about the deflections of `fineness`.
/// Their deflections are measured. Runs in the importing process only.
StepTriangles tessellate(const TopoDS_Shape& shape, const Fineness& fineness, const FaceEntities& entities,
                         double scale, bool mirrored);

/// The triangles in the file, scaled and mirrored as in tessellate(). They belong to no face.
StepTriangles trianglesOf(const StepTessellation& held, double scale, bool mirrored);

}  // namespace glissade
