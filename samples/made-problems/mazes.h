#pragma once

#include <array>
#include <vector>

#include "engine/base/random_stream.h"
#include "samples/made-problems/made_problem.h"

namespace glissade::made {

using Cell = std::array<int, 3>;

/// A maze of cells of 1 m. A random walk joins them to a tree, and turns back at dead ends.
class Maze {
 public:
  Maze(const Cell& size, std::uint64_t seed) : size_(size), open_(count()), seen_(count()) {
    RandomStream stream(seed, "maze");
    walk(stream);
  }

  /// Whether a cell is joined to the next one along an axis.
  bool isOpen(const Cell& cell, int axis) const { return open_[indexOf(cell)][static_cast<std::size_t>(axis)]; }
  const Cell& size() const { return size_; }

 private:
  std::size_t count() const { return static_cast<std::size_t>(size_[0]) * size_[1] * size_[2]; }
  std::size_t indexOf(const Cell& cell) const {
    return (static_cast<std::size_t>(cell[0]) * size_[1] + cell[1]) * size_[2] + cell[2];
  }

  void walk(RandomStream& stream) {
    std::vector<Cell> way{{0, 0, 0}};
    seen_[0] = true;
    while (!way.empty()) {
      const Cell at = way.back();
      std::vector<std::pair<int, int>> steps;
      for (int axis = 0; axis < 3; ++axis) {
        for (const int sense : {-1, 1}) {
          Cell to = at;
          to[axis] += sense;
          if (to[axis] >= 0 && to[axis] < size_[axis] && !seen_[indexOf(to)]) steps.emplace_back(axis, sense);
        }
      }
      if (steps.empty()) {
        way.pop_back();
        continue;
      }
      const auto [axis, sense] = steps[static_cast<std::size_t>(stream.uniform() * static_cast<double>(steps.size()))];
      Cell to = at;
      to[axis] += sense;
      open_[indexOf(sense > 0 ? at : to)][static_cast<std::size_t>(axis)] = true;
      seen_[indexOf(to)] = true;
      way.push_back(to);
    }
  }

  Cell size_;
  std::vector<std::array<bool, 3>> open_;
  std::vector<bool> seen_;
};

/// Walls of thickness `thick` between cells that are not joined, and around the maze.
inline TriangleMesh wallsOf(const Maze& maze, double thick) {
  TriangleMesh walls;
  const Vector3 half = Vector3::Constant(thick / 2.0);
  const auto add = [&](const Cell& cell, int axis) {
    Vector3 least(cell[0], cell[1], cell[2]);
    Vector3 most = least + Vector3::Ones();
    least[axis] = most[axis];
    append(walls, boxBetween(least - half, most + half));
  };
  for (int axis = 0; axis < 3; ++axis) {
    Cell end = maze.size();
    const int last = end[axis] - 1;
    Cell cell{};
    for (cell[0] = axis == 0 ? -1 : 0; cell[0] < end[0]; ++cell[0]) {
      for (cell[1] = axis == 1 ? -1 : 0; cell[1] < end[1]; ++cell[1]) {
        for (cell[2] = axis == 2 ? -1 : 0; cell[2] < end[2]; ++cell[2]) {
          const bool inside = cell[axis] >= 0 && cell[axis] < last;
          if (!inside || !maze.isOpen(cell, axis)) add(cell, axis);
        }
      }
    }
  }
  return walls;
}

/// An L with arms of equal length and its corner at the origin.
inline TriangleMesh angleBar(double arm, double thick) {
  const double half = thick / 2.0;
  TriangleMesh bar = boxBetween({-half, -half, -half}, {arm - half, half, half});
  append(bar, boxBetween({-half, half, -half}, {half, arm - half, half}));
  return bar;
}

inline MadeProblem inMaze(const std::string& name, const std::string& description, const Cell& size, std::uint64_t seed,
                          const TriangleMesh& object) {
  constexpr double kThick = 0.1;
  const Vector3 end(size[0], size[1], size[2]);
  const Vector3 back = Vector3::Constant(0.2);
  const Vector3 middle = Vector3::Constant(0.5);
  return {name,
          description,
          object,
          wallsOf(Maze(size, seed), kThick),
          Pose::translation(middle - back),
          turnedAt(end - middle + back, std::acos(-1.0), {0, 0, 1}),
          Box3(Vector3::Zero(), end)};
}

inline MadeProblem flatMaze(std::uint64_t seed) {
  return inMaze("maze-flat-" + std::to_string(seed), "An angle through a maze of 8 by 8 cells on one floor.", {8, 8, 1},
                seed, angleBar(0.6, 0.15));
}

inline MadeProblem cubicMaze(std::uint64_t seed) {
  return inMaze("maze-cube-" + std::to_string(seed), "An angle through a maze of 4 by 4 by 4 cells.", {4, 4, 4}, seed,
                angleBar(0.6, 0.15));
}

}  // namespace glissade::made
