#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <string>
#include <vector>

/// Closed triangle surfaces for the pump sample, their unions and cuts, and their files. Metres.
namespace glissade::sample {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Transform = Kernel::Aff_transformation_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Ring = std::vector<Point>;
using Outline = std::vector<std::array<double, 2>>;
enum class Axis { X, Y, Z };

/// The i-th of n points on the unit circle; `phase` is a part of the pitch.
std::array<double, 2> onCircle(int i, int n, double phase);
/// The closed surface through rings of equal size, with an end cap on the first and the last.
Mesh loft(const std::vector<Ring>& rings);
/// Turns z to the axis by a cyclic permutation, and moves the origin to `origin`.
Mesh placed(Mesh mesh, Axis axis, const Point& origin);
/// An outline in x and y, extruded along z in so many pieces.
Mesh extrusion(const Outline& outline, double from, double to, int pieces = 1);
/// Boxes between two opposite corners, and about a middle.
Mesh box(const Point& a, const Point& b);
Mesh boxAt(const Point& middle, double x, double y, double z);
/// A rectangle about the origin with rounded corners of `steps` pieces.
Outline roundedRectangle(double width, double height, double radius, int steps);
/// A surface of revolution about z through (z, radius); its ends are flat.
Mesh revolution(const Outline& profile, int segments);
Mesh cylinder(Axis axis, const Point& foot, double radius, double length, int segments);
/// A tube about a polyline with rounded corners, its cross-section carried along without twist. Corners
/// are rounded by parabolas that begin `bend` before them.
Mesh tube(const Ring& corners, double bend, double radius, int segments);

/// Both functions throw if the result is not a manifold.
void unite(Mesh& mesh, Mesh part);
void subtract(Mesh& mesh, Mesh part);

/// A point as three numbers of six decimals at most.
std::string numbers(const Point& p, const char* separator);
void writeFile(const std::string& path, const std::string& text);
/// Sorts vertices and triangles, because corefinement numbers them by address, and welds vertices that rounding merges.
void writeObj(const std::string& path, const Mesh& mesh);

}  // namespace glissade::sample
