#pragma once

#include <gp_XYZ.hxx>

#include "engine/import/step_tessellation.h"

namespace glissade {

/// The volume and area of a shape's triangles. Millimetres.
struct TriangleMeasures {
  double volume = 0.0;  ///< negative if the shape is inside out
  double area = 0.0;
  double deflection = 0.0;  ///< largest deflection of the faces
  double size = 0.0;        ///< distance of the farthest vertex from `origin`
  gp_XYZ origin;            ///< a vertex
  gp_XYZ moment;            ///< moment of the volume about `origin`: the centroid is origin + moment / volume

  /// Largest deviation of the volume from that of the true surface, cubic millimetres.
  double uncertainty() const { return deflection * area; }
};

TriangleMeasures measuresOf(const StepTriangles& triangles);

}  // namespace glissade
