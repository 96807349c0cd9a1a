#pragma once

#include <TopoDS_Shape.hxx>
#include <cstdint>
#include <vector>

#include "engine/import/import_protocol.h"
#include "engine/import/step_healing.h"
#include "engine/import/step_tessellated.h"

namespace glissade {

/// A shape as triangles that run counter-clockwise seen from outside; a vertex once a face. What faces
/// share along an edge is equal bit by bit.
struct StepTriangles {
  import_protocol::Shape record;
  std::vector<double> vertices;  ///< x y z, millimetres
  std::vector<std::uint32_t> indices;
  std::vector<import_protocol::Face> faces;  ///< of the triangles in their order
  std::vector<HealedFace> healed;            ///< whose triangles were wrong at first
  /// Of a solid with healed faces: its triangles and its faces enclose volumes that differ by more than the deflection
  /// times the area.
  bool volumeDiffers = false;
  double volume = 0.0;       ///< of the triangles, cubic millimetres; where it differs
  double exactVolume = 0.0;  ///< likewise, of the faces
};

/// Triangles that are about as far off the surface as `fineness` says, or less, of the shape taken `scale` times as
/// large, and mirrored in x where that is asked for. How far they are off is measured. Runs in the importing process
/// only.
StepTriangles tessellate(const TopoDS_Shape& shape, const Fineness& fineness, double scale, bool mirrored);

/// The triangles that the file holds, as tessellate() scales and mirrors them. They stand for no face.
StepTriangles trianglesOf(const StepTessellation& held, double scale, bool mirrored);

}  // namespace glissade
