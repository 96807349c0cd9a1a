#include "tests/oracle/shapes.h"

#include <algorithm>

namespace glissade::oracle {
namespace {

Point at(const Corner& corner, double z) { return {corner[0], corner[1], z}; }

void addQuad(Triangles& triangles, const Point& a, const Point& b, const Point& c, const Point& d) {
  triangles.push_back({a, b, c});
  triangles.push_back({a, c, d});
}

/// The side faces of an outline, seen from outside.
void addSides(Triangles& triangles, const Outline& outline, double half) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Corner& a = outline[i];
    const Corner& b = outline[(i + 1) % outline.size()];
    addQuad(triangles, at(a, -half), at(b, -half), at(b, half), at(a, half));
  }
}

}  // namespace

Outline rectangle(double width, double depth) {
  const double x = width / 2.0;
  const double y = depth / 2.0;
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

Outline regularPolygon(int corners, double radius) {
  Outline outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * (i + 0.5) / corners;
    outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return outline;
}

Outline squareOf(int corners, double side) {
  Outline outline = regularPolygon(corners, 1.0);
  for (Corner& corner : outline) {
    const double reach = 0.5 * side / std::max(std::abs(corner[0]), std::abs(corner[1]));
    corner = {reach * corner[0], reach * corner[1]};
  }
  return outline;
}

Triangles extruded(const Outline& outline, double height, std::size_t centre) {
  Triangles triangles;
  const double half = height / 2.0;
  const std::size_t n = outline.size();
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Corner& a = outline[centre];
    const Corner& b = outline[(centre + i) % n];
    const Corner& c = outline[(centre + i + 1) % n];
    triangles.push_back({at(a, half), at(b, half), at(c, half)});
    triangles.push_back({at(a, -half), at(c, -half), at(b, -half)});
  }
  addSides(triangles, outline, half);
  return triangles;
}

Triangles extrudedRing(const Outline& outer, const Outline& inner, double height) {
  Triangles triangles;
  const double half = height / 2.0;
  const std::size_t n = outer.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = (i + 1) % n;
    addQuad(triangles, at(outer[i], half), at(outer[k], half), at(inner[k], half), at(inner[i], half));
    addQuad(triangles, at(outer[i], -half), at(inner[i], -half), at(inner[k], -half), at(outer[k], -half));
  }
  addSides(triangles, outer, half);
  addSides(triangles, Outline(inner.rbegin(), inner.rend()), half);
  return triangles;
}

Triangles box(double width, double depth, double height) { return extruded(rectangle(width, depth), height); }

Triangles lShape(double arm, double thickness, double height) {
  return extruded({{0, 0}, {arm, 0}, {arm, thickness}, {thickness, thickness}, {thickness, arm}, {0, arm}}, height, 3);
}

Triangles hollowBox(double outer, double inner) {
  Triangles triangles = box(outer, outer, outer);
  for (const auto& [a, b, c] : box(inner, inner, inner)) triangles.push_back({a, c, b});
  return triangles;
}

Triangles moved(const Triangles& triangles, const Point& by) {
  Triangles result = triangles;
  for (Triangle& triangle : result) {
    for (Point& p : triangle) p = p + by;
  }
  return result;
}

}  // namespace glissade::oracle
