#pragma once

#include "tests/oracle/shapes.h"

namespace glissade::oracle {

/// An outline at a height. Outlines of one solid have corners in the same directions from the z-axis.
struct Ring {
  Outline outline;
  double z = 0.0;
};

/// A plane face. A cap is star-shaped about the z-axis.
struct Polygon {
  std::vector<Point> corners;  ///< counter-clockwise, seen from outside
  bool cap = false;
};

/// The solid between a cap at the first ring, the faces from each ring to the next one, and a cap at the last ring. The
/// first cap faces down. Rings that go up are outer walls, rings that go down are walls of a cavity.
std::vector<Polygon> ringSolid(const std::vector<Ring>& rings);

Triangles trianglesOf(const std::vector<Polygon>& polygons);

/// The directions of a regular polygon; the radius of corner i is radii[i % radii.size()].
Outline polarOutline(int corners, const std::vector<double>& radii);

}  // namespace glissade::oracle
