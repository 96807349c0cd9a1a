#pragma once

#include <gp_XYZ.hxx>

#include "engine/import/step_tessellation.h"

namespace glissade {

/// What the triangles of a shape enclose and cover. Millimetres.
struct TriangleMeasures {
  double volume = 0.0;  ///< below 0 where the shape is inside out
  double area = 0.0;
  double deflection = 0.0;  ///< the largest of the faces
  double size = 0.0;        ///< from the origin of the moment to the farthest vertex
  gp_XYZ origin;            ///< a vertex
  gp_XYZ moment;            ///< of the volume about `origin`: the centroid is origin + moment / volume

  /// Cubic millimetres that the volume may be off that of the true surface.
  double uncertainty() const { return deflection * area; }
};

TriangleMeasures measuresOf(const StepTriangles& triangles);

}  // namespace glissade
