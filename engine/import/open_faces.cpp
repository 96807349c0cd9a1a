#include "engine/import/open_faces.h"

#include <algorithm>
#include <array>
#include <utility>

namespace glissade {
namespace {

/// A side of a triangle, from the lesser to the greater corner.
struct TriangleSide {
  std::pair<std::size_t, std::size_t> corners;
  int direction;     ///< 1: from the lesser corner on; -1: the other way
  std::size_t face;  ///< index
};

/// The number of each vertex; equal points have one number.
std::vector<std::size_t> weldedVertices(const FaceTriangles& triangles) {
  using Point = std::array<double, 3>;
  const std::size_t count = triangles.vertices.size() / 3;
  std::vector<std::pair<Point, std::size_t>> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double* at = &triangles.vertices[3 * i];
    points[i] = {{at[0], at[1], at[2]}, i};
  }
  std::sort(points.begin(), points.end());
  std::vector<std::size_t> numbers(count);
  for (std::size_t i = 0; i < count; ++i) {
    const bool isSame = i > 0 && points[i].first == points[i - 1].first;
    numbers[points[i].second] = isSame ? numbers[points[i - 1].second] : i;
  }
  return numbers;
}

std::vector<TriangleSide> sidesOf(const FaceTriangles& triangles) {
  const std::vector<std::size_t> numbers = weldedVertices(triangles);
  std::vector<TriangleSide> sides;
  sides.reserve(triangles.indices.size());
  std::size_t triangle = 0;
  for (std::size_t face = 0; face < triangles.faces.size(); ++face) {
    for (const std::size_t end = triangle + triangles.faces[face].triangles; triangle < end; ++triangle) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t from = numbers[triangles.indices[3 * triangle + i]];
        const std::size_t to = numbers[triangles.indices[3 * triangle + (i + 1) % 3]];
        if (from != to) sides.push_back({std::minmax(from, to), from < to ? 1 : -1, face});
      }
    }
  }
  return sides;
}

}  // namespace

std::set<std::string> openFaces(const FaceTriangles& triangles) {
  std::vector<TriangleSide> sides = sidesOf(triangles);
  std::sort(sides.begin(), sides.end(),
            [](const TriangleSide& a, const TriangleSide& b) { return a.corners < b.corners; });
  std::set<std::string> entities;
  for (auto first = sides.begin(); first != sides.end();) {
    const auto isOther = [&](const TriangleSide& side) { return side.corners != first->corners; };
    const auto end = std::find_if(first, sides.end(), isOther);
    int balance = 0;
    for (auto side = first; side != end; ++side) balance += side->direction;
    for (auto side = first; side != end && balance != 0; ++side) entities.insert(triangles.entities[side->face]);
    first = end;
  }
  return entities;
}

}  // namespace glissade
