#include "samples/pump/shapes.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/transform.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace glissade::sample {

namespace pmp = CGAL::Polygon_mesh_processing;

/// The i-th of n points on the unit circle; `phase` is a part of the pitch.
std::array<double, 2> onCircle(int i, int n, double phase) {
  const double angle = 2 * std::acos(-1.0) * (i + phase) / n;
  return {std::cos(angle), std::sin(angle)};
}

/// The closed surface through rings of equal size, with an end cap on the first and the last.
Mesh loft(const std::vector<Ring>& rings) {
  Mesh mesh;
  std::vector<std::vector<Mesh::Vertex_index>> ids(rings.size());
  for (std::size_t r = 0; r < rings.size(); ++r) {
    for (const Point& p : rings[r]) ids[r].push_back(mesh.add_vertex(p));
  }
  for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
    for (std::size_t i = 0, n = rings[r].size(); i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      mesh.add_face(ids[r][i], ids[r][j], ids[r + 1][j], ids[r + 1][i]);
    }
  }
  mesh.add_face(std::vector<Mesh::Vertex_index>(ids.front().rbegin(), ids.front().rend()));
  mesh.add_face(ids.back());
  if (!pmp::triangulate_faces(mesh)) throw std::runtime_error("a face cannot be triangulated");
  if (!pmp::is_outward_oriented(mesh)) pmp::reverse_face_orientations(mesh);
  return mesh;
}

/// Turns z to the axis by a cyclic permutation, and moves the origin to `origin`.
Mesh placed(Mesh mesh, Axis axis, const Point& origin) {
  const double x = origin.x(), y = origin.y(), z = origin.z();
  pmp::transform(axis == Axis::X   ? Transform(0, 0, 1, x, 1, 0, 0, y, 0, 1, 0, z)
                 : axis == Axis::Y ? Transform(0, 1, 0, x, 0, 0, 1, y, 1, 0, 0, z)
                                   : Transform(1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z),
                 mesh);
  return mesh;
}

Mesh extrusion(const Outline& outline, double from, double to, int pieces) {
  std::vector<Ring> rings(pieces + 1);
  for (int i = 0; i <= pieces; ++i) {
    for (const auto& [x, y] : outline) rings[i].emplace_back(x, y, from + (to - from) * i / pieces);
  }
  return loft(rings);
}

Mesh box(const Point& a, const Point& b) {
  return extrusion({{a.x(), a.y()}, {b.x(), a.y()}, {b.x(), b.y()}, {a.x(), b.y()}}, a.z(), b.z());
}

Mesh boxAt(const Point& middle, double x, double y, double z) {
  const Vector half(x / 2, y / 2, z / 2);
  return box(middle - half, middle + half);
}

/// A rectangle about the origin with rounded corners of `steps` pieces.
Outline roundedRectangle(double width, double height, double radius, int steps) {
  Outline outline;
  for (int corner = 0; corner < 4; ++corner) {
    const double x = (corner == 0 || corner == 3 ? 1 : -1) * (width / 2 - radius);
    const double y = (corner < 2 ? 1 : -1) * (height / 2 - radius);
    for (int i = 0; i <= steps; ++i) {
      const auto [c, s] = onCircle(corner * steps + i, 4 * steps, 0);
      outline.push_back({x + radius * c, y + radius * s});
    }
  }
  return outline;
}

/// A surface of revolution about z through (z, radius); its ends are flat.
Mesh revolution(const Outline& profile, int segments) {
  std::vector<Ring> rings(profile.size());
  for (std::size_t r = 0; r < profile.size(); ++r) {
    for (int i = 0; i < segments; ++i) {
      const auto [c, s] = onCircle(i, segments, 0.37);
      rings[r].emplace_back(profile[r][1] * c, profile[r][1] * s, profile[r][0]);
    }
  }
  return loft(rings);
}

Mesh cylinder(Axis axis, const Point& foot, double radius, double length, int segments) {
  return placed(revolution({{0, radius}, {length, radius}}, segments), axis, foot);
}

Vector unit(const Vector& v) { return v / std::sqrt(v.squared_length()); }

/// A polyline whose corners are rounded by parabolas that begin `bend` before the corner.
Ring rounded(const Ring& corners, double bend) {
  constexpr int kSteps = 8;
  Ring line{corners.front()};
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Vector in = bend * unit(corners[i] - corners[i - 1]), out = bend * unit(corners[i + 1] - corners[i]);
    for (int k = 0; k <= kSteps; ++k) {
      const double t = static_cast<double>(k) / kSteps;
      line.push_back(corners[i] - (1 - t) * (1 - t) * in + t * t * out);
    }
  }
  line.push_back(corners.back());
  return line;
}

/// A tube about a polyline with rounded corners, its cross-section carried along without twist.
Mesh tube(const Ring& corners, double bend, double radius, int segments) {
  const Ring line = rounded(corners, bend);
  std::vector<Ring> rings(line.size());
  Vector normal(0.31, 0.53, 0.79);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vector tangent = unit(line[std::min(i + 1, line.size() - 1)] - line[i == 0 ? 0 : i - 1]);
    normal = unit(normal - (normal * tangent) * tangent);
    for (int k = 0; k < segments; ++k) {
      const auto [c, s] = onCircle(k, segments, 0);
      rings[i].push_back(line[i] + radius * (c * normal + s * CGAL::cross_product(tangent, normal)));
    }
  }
  return loft(rings);
}

// Boolean operations. Parts that do not touch are combined into one operand, because one operation after the other
// would cut slivers of slivers.

void unite(Mesh& mesh, Mesh part) {
  if (!pmp::corefine_and_compute_union(mesh, part, mesh)) throw std::runtime_error("a union is not a manifold");
}

void subtract(Mesh& mesh, Mesh part) {
  if (!pmp::corefine_and_compute_difference(mesh, part, mesh)) throw std::runtime_error("a cut is not a manifold");
}

/// Six decimals without trailing zeros.
std::string shortNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6f", value);
  std::string number(text);
  number.erase(number.find_last_not_of('0') + 1);
  if (number.back() == '.') number.pop_back();
  return number == "-0" ? "0" : number;
}

std::string numbers(const Point& p, const char* separator) {
  return shortNumber(p.x()) + separator + shortNumber(p.y()) + separator + shortNumber(p.z());
}

void writeFile(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  if (!file.write(text.data(), static_cast<std::streamsize>(text.size())).flush()) {
    throw std::runtime_error(path + " cannot be written");
  }
}

/// The shortest text of the nearest 32-bit number. The importer used to round coordinates to 32 bits, and the
/// published results on the pump were measured then; they stay the same because the file holds these numbers.
std::string singleNumber(double value) {
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, static_cast<double>(static_cast<float>(value))).ptr;
  const std::string number(text, end);
  return number == "-0" ? "0" : number;
}

/// Sorts vertices and triangles, because corefinement numbers them by address, and welds vertices that rounding merges.
void writeObj(const std::string& path, const Mesh& mesh) {
  if (!CGAL::is_closed(mesh)) throw std::runtime_error(path + " is not closed");
  std::map<std::array<long, 3>, int> numbering;  // by the coordinates in micrometres
  const auto key = [&](Mesh::Vertex_index v) {
    const Point& p = mesh.point(v);
    return std::array<long, 3>{std::lround(p.x() * 1e6), std::lround(p.y() * 1e6), std::lround(p.z() * 1e6)};
  };
  for (const auto v : mesh.vertices()) numbering[key(v)] = 0;
  std::string text;
  int count = 0;
  for (auto& [p, number] : numbering) {
    number = ++count;
    text += "v";
    for (const long micrometres : p) text += " " + singleNumber(std::stod(shortNumber(1e-6 * micrometres)));
    text += "\n";
  }
  std::set<std::array<int, 3>> triangles;
  for (const auto f : mesh.faces()) {
    std::array<int, 3> corners{};
    int i = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) corners[i++] = numbering[key(v)];
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[0] != corners[2]) triangles.insert(corners);
  }
  for (const auto& [a, b, c] : triangles) {
    text += "f " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  }
  writeFile(path, text);
  std::cout << path << ": " << triangles.size() << " triangles\n";
}

}  // namespace glissade::sample
