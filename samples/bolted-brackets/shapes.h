#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade::bolted_brackets {

/// Vertices of a circle. Its directions include the corners of a hexagon and of a square.
inline constexpr std::uint32_t kSteps = 24;
/// Radius of bolts, rod and all holes, metres; they touch.
inline constexpr double kRadius = 0.004;
/// Half of the hexagon's width across flats.
inline constexpr double kFlat = 0.0065;

inline Vector3 onCircle(std::uint32_t i, double radius, double z) {
  const double angle = 2.0 * std::numbers::pi * (i % kSteps) / kSteps;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/// A point of a hexagon with corners at 0 and every 60 degrees.
inline Vector3 onHexagon(std::uint32_t i, double z) {
  const double sixth = std::numbers::pi / 3.0;
  const double angle = 2.0 * std::numbers::pi * (i % kSteps) / kSteps;
  const double fromFlat = std::fmod(angle + 1e-12, sixth) - 0.5 * sixth;
  return onCircle(i, kFlat / std::cos(fromFlat), z);
}

/// Rings of vertices about z, one after the other; the outside is to the right of their sequence.
class Rings {
 public:
  template <class Point>
  void add(const Point& point) {
    for (std::uint32_t i = 0; i < kSteps; ++i) mesh_.vertices.push_back(point(i));
    if (mesh_.vertices.size() > kSteps) join(count() - 2, count() - 1);
  }
  /// Joins the last ring to the first one.
  TriangleMesh closed() {
    join(count() - 1, 0);
    return mesh_;
  }
  /// Closes the first and the last ring by flat faces.
  TriangleMesh capped() {
    const std::uint32_t last = kSteps * (count() - 1);
    cap(0, false);
    cap(last, true);
    return mesh_;
  }

 private:
  std::uint32_t count() const { return static_cast<std::uint32_t>(mesh_.vertices.size() / kSteps); }
  void join(std::uint32_t low, std::uint32_t high) {
    for (std::uint32_t i = 0; i < kSteps; ++i) {
      const std::uint32_t next = (i + 1) % kSteps;
      mesh_.triangles.push_back({kSteps * low + i, kSteps * low + next, kSteps * high + next});
      mesh_.triangles.push_back({kSteps * low + i, kSteps * high + next, kSteps * high + i});
    }
  }
  void cap(std::uint32_t ring, bool upwards) {
    const auto middle = static_cast<std::uint32_t>(mesh_.vertices.size());
    mesh_.vertices.emplace_back(0.0, 0.0, mesh_.vertices[ring].z());
    for (std::uint32_t i = 0; i < kSteps; ++i) {
      const std::uint32_t a = ring + i;
      const std::uint32_t b = ring + (i + 1) % kSteps;
      mesh_.triangles.push_back(upwards ? TriangleIndices{a, b, middle} : TriangleIndices{b, a, middle});
    }
  }

  TriangleMesh mesh_;
};

/// A rod along z with its middle at the origin.
inline TriangleMesh rod() {
  constexpr double kHalf = 0.043;
  Rings rings;
  for (const double z : {-kHalf, kHalf}) rings.add([z](std::uint32_t i) { return onCircle(i, kRadius, z); });
  return rings.capped();
}

/// A bolt along z: the head lies on z = 0, the shank goes down.
inline TriangleMesh bolt() {
  constexpr double kLength = 0.026;
  constexpr double kHead = 0.0053;
  Rings rings;
  for (const double z : {-kLength, 0.0}) rings.add([z](std::uint32_t i) { return onCircle(i, kRadius, z); });
  for (const double z : {0.0, kHead}) rings.add([z](std::uint32_t i) { return onHexagon(i, z); });
  return rings.capped();
}

/// A nut about z, from z = 0 upwards.
inline TriangleMesh nut() {
  constexpr double kHeight = 0.0065;
  Rings rings;
  for (const double z : {kHeight, 0.0}) rings.add([z](std::uint32_t i) { return onCircle(i, kRadius, z); });
  for (const double z : {0.0, kHeight}) rings.add([z](std::uint32_t i) { return onHexagon(i, z); });
  return rings.closed();
}

/// Boxes of a grid, some of them with round holes.
class Blocks {
 public:
  /// `lines`: lines of the grid along x, y and z, metres.
  explicit Blocks(std::array<std::vector<double>, 3> lines) : lines_(std::move(lines)) {
    cells_.resize(sizeOf(0) * sizeOf(1) * sizeOf(2));
  }

  struct Cell {
    bool filled = false;
    int hole = -1;  ///< 0, 1, 2: a hole along x, y, z through the middle; -1: none
  };
  using Index = std::array<std::size_t, 3>;

  std::size_t sizeOf(int axis) const { return lines_[static_cast<std::size_t>(axis)].size() - 1; }
  Cell& at(const Index& i) { return cells_[(i[0] * sizeOf(1) + i[1]) * sizeOf(2) + i[2]]; }

  TriangleMesh surface() {
    for (std::size_t x = 0; x < sizeOf(0); ++x) {
      for (std::size_t y = 0; y < sizeOf(1); ++y) {
        for (std::size_t z = 0; z < sizeOf(2); ++z) {
          if (at({x, y, z}).filled) addCell({x, y, z});
        }
      }
    }
    return welded(mesh_);
  }

 private:
  double line(int axis, std::size_t i) const { return lines_[static_cast<std::size_t>(axis)][i]; }

  void addCell(const Index& cell) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      for (const bool upper : {false, true}) {
        Index beside = cell;
        const bool atBorder = upper ? cell[a] + 1 == sizeOf(axis) : cell[a] == 0;
        if (!atBorder) beside[a] += upper ? 1 : std::size_t(-1);
        if (atBorder || !at(beside).filled) addFace(cell, axis, upper);
      }
    }
    if (at(cell).hole >= 0) addWall(cell, at(cell).hole);
  }

  /// A point of the cell's face: `u` and `v` along the two other axes in their cyclic order.
  static Vector3 point(int axis, double along, double u, double v) {
    Vector3 p;
    p[axis] = along;
    p[(axis + 1) % 3] = u;
    p[(axis + 2) % 3] = v;
    return p;
  }
  Vector3 onHole(const Index& cell, int axis, double along, std::uint32_t i) const {
    const auto middle = [&](int across) {
      const std::size_t at = cell[static_cast<std::size_t>(across)];
      return 0.5 * (line(across, at) + line(across, at + 1));
    };
    const Vector3 on = onCircle(i, kRadius, 0.0);
    return point(axis, along, middle((axis + 1) % 3) + on.x(), middle((axis + 2) % 3) + on.y());
  }

  void addFace(const Index& cell, int axis, bool upper) {
    const auto end = [&](int along, bool high) {
      return line(along, cell[static_cast<std::size_t>(along)] + (high ? 1 : 0));
    };
    const auto corner = [&](bool u, bool v) {
      return point(axis, end(axis, upper), end((axis + 1) % 3, u), end((axis + 2) % 3, v));
    };
    const std::array<Vector3, 4> corners{corner(true, true), corner(false, true), corner(false, false),
                                         corner(true, false)};  // at 45 degrees, 135, ...
    if (at(cell).hole != axis) {
      add(corners[0], corners[1], corners[2], upper);
      add(corners[0], corners[2], corners[3], upper);
      return;
    }
    constexpr std::uint32_t kQuarter = kSteps / 4;
    for (std::uint32_t i = 0; i < kSteps; ++i) {
      const Vector3 from = onHole(cell, axis, end(axis, upper), i);
      const std::uint32_t quarter = i / kQuarter;
      add(from, corners[quarter], onHole(cell, axis, end(axis, upper), i + 1), upper);
      if (i % kQuarter == 0) add(from, corners[(quarter + 3) % 4], corners[quarter], upper);
    }
  }

  void addWall(const Index& cell, int axis) {
    const std::size_t at = cell[static_cast<std::size_t>(axis)];
    const double low = line(axis, at);
    const double high = line(axis, at + 1);
    for (std::uint32_t i = 0; i < kSteps; ++i) {
      add(onHole(cell, axis, high, i), onHole(cell, axis, high, i + 1), onHole(cell, axis, low, i + 1), true);
      add(onHole(cell, axis, high, i), onHole(cell, axis, low, i + 1), onHole(cell, axis, low, i), true);
    }
  }

  void add(const Vector3& a, const Vector3& b, const Vector3& c, bool forwards) {
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    mesh_.vertices.insert(mesh_.vertices.end(), {a, b, c});
    mesh_.triangles.push_back(forwards ? TriangleIndices{first, first + 1, first + 2}
                                       : TriangleIndices{first, first + 2, first + 1});
  }

  std::array<std::vector<double>, 3> lines_;
  std::vector<Cell> cells_;
  TriangleMesh mesh_;
};

/// A plate whose upper face is z = 0, with a hole at 40 mm on either side.
inline TriangleMesh plate() {
  Blocks blocks({{{-0.06, -0.05, -0.03, 0.03, 0.05, 0.06}, {-0.025, -0.01, 0.01, 0.025}, {-0.008, 0.0}}});
  for (std::size_t x = 0; x < 5; ++x) {
    for (std::size_t y = 0; y < 3; ++y) blocks.at({x, y, 0}).filled = true;
  }
  for (const std::size_t x : {1, 3}) blocks.at({x, 1, 0}).hole = 2;
  return blocks.surface();
}

/// An L on z = 0: the upright part at x from 24 to 30 mm with a hole along x, the foot outwards with a hole along z.
inline TriangleMesh bracket() {
  Blocks blocks({{{0.024, 0.03, 0.05, 0.054}, {-0.018, -0.01, 0.01, 0.018}, {0.0, 0.006, 0.024, 0.044, 0.048}}});
  for (std::size_t y = 0; y < 3; ++y) {
    for (std::size_t x = 0; x < 3; ++x) blocks.at({x, y, 0}).filled = true;
    for (std::size_t z = 0; z < 4; ++z) blocks.at({0, y, z}).filled = true;
  }
  blocks.at({1, 1, 0}).hole = 2;
  blocks.at({0, 1, 2}).hole = 0;
  return blocks.surface();
}

}  // namespace glissade::bolted_brackets
