#pragma once

#include <array>
#include <vector>

#include "engine/geometry/primitives.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade::puzzles {

inline TriangleMesh join(const std::vector<TriangleMesh>& parts) {
  TriangleMesh all;
  for (const TriangleMesh& part : parts) {
    const auto shift = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const auto& [a, b, c] : part.triangles) all.triangles.push_back({a + shift, b + shift, c + shift});
  }
  return all;
}

inline TriangleMesh boxBetween(const Vector3& least, const Vector3& most) {
  return transformed(makeBox(most - least), Pose::translation((least + most) / 2.0));
}

/// A bar of 10 mm, bent to a rectangle in x and y with an opening of 10.5 mm. Metres.
inline TriangleMesh bentBar() {
  constexpr double kThick = 0.01;
  constexpr double kMouth = 0.0105;
  constexpr double kX = 0.035;  // half of its outer size
  constexpr double kY = 0.025;
  constexpr double kZ = kThick / 2.0;  // half of its height
  const auto piece = [kZ](double x0, double y0, double x1, double y1) {
    return boxBetween({x0, y0, -kZ}, {x1, y1, kZ});
  };
  return join({piece(-kX, -kY, kX, -kY + kThick), piece(-kX, -kY, -kX + kThick, kY), piece(kX - kThick, -kY, kX, kY),
               piece(-kX, kY - kThick, -kMouth / 2.0, kY), piece(kMouth / 2.0, kY - kThick, kX, kY)});
}

/// The burr is made of cubes in a block of kCubes on each side. All lengths are in cubes, except kCube in metres.
inline constexpr double kCube = 0.01;
inline constexpr int kCubes = 7;
inline constexpr double kPlay = 0.03;  ///< play of the piece on each side, in cubes

using Cube = std::array<int, 3>;

/// Three cubes that form an angle.
inline const std::vector<Cube> kPiece{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
/// Moves of the piece by one cube each, until it has left the block.
inline const std::vector<Cube> kMoves{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {1, 0, 0},
                                      {1, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1},  {0, 0, 1}, {0, 0, 1},  {0, 0, 1}};
inline const Cube kStart{2, 2, 2};

inline TriangleMesh boxOfCubes(const Vector3& least, const Vector3& most) {
  return boxBetween(kCube * least, kCube * most);
}

/// The piece with its first cube at the origin.
inline TriangleMesh burrPiece() {
  const Vector3 play = Vector3::Constant(kPlay);
  std::vector<TriangleMesh> arms;
  for (const Cube& cube : kPiece) {
    const Vector3 end(cube[0] + 1, cube[1] + 1, cube[2] + 1);
    arms.push_back(boxOfCubes(play, end - play));
  }
  return join(arms);
}

/// The block without the cubes that the piece passes through, as rows of cubes along z.
inline TriangleMesh burrBlock() {
  std::array<std::array<std::array<bool, kCubes>, kCubes>, kCubes> open{};
  Cube at = kStart;
  const auto clear = [&] {
    for (const Cube& cube : kPiece) {
      const int x = at[0] + cube[0];
      const int y = at[1] + cube[1];
      const int z = at[2] + cube[2];
      if (z < kCubes) open[x][y][z] = true;
    }
  };
  clear();
  for (const Cube& move : kMoves) {
    for (int axis = 0; axis < 3; ++axis) at[axis] += move[axis];
    clear();
  }
  std::vector<TriangleMesh> rows;
  for (int x = 0; x < kCubes; ++x) {
    for (int y = 0; y < kCubes; ++y) {
      for (int z = 0; z < kCubes;) {
        const int first = z;
        while (z < kCubes && !open[x][y][z]) ++z;
        if (z > first) rows.push_back(boxOfCubes(Vector3(x, y, first), Vector3(x + 1, y + 1, z)));
        while (z < kCubes && open[x][y][z]) ++z;
      }
    }
  }
  return join(rows);
}

}  // namespace glissade::puzzles
