#pragma once

#include "tests/oracle/vectors.h"

namespace glissade::oracle {

/// A corner of an outline in the plane z = 0.
using Corner = std::array<double, 2>;
using Outline = std::vector<Corner>;

/// A counter-clockwise rectangle about the origin.
Outline rectangle(double width, double depth);
Outline regularPolygon(int corners, double radius);
/// The directions of a regular polygon on the border of a square.
Outline squareOf(int corners, double side);

/// A solid between z = -height / 2 and height / 2. The outline is star-shaped about its corner `centre`.
Triangles extruded(const Outline& outline, double height, std::size_t centre = 0);
/// A solid between an outer and an inner outline with equal numbers of corners, of the given height.
Triangles extrudedRing(const Outline& outer, const Outline& inner, double height);
Triangles box(double width, double depth, double height);
/// An L of the given arms; its corner is at the origin of the plane.
Triangles lShape(double arm, double thickness, double height);
/// A box of the given outer edge around an empty box of the inner edge.
Triangles hollowBox(double outer, double inner);

Triangles moved(const Triangles& triangles, const Point& by);

}  // namespace glissade::oracle
