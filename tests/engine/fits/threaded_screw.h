#pragma once

#include <algorithm>
#include <cmath>

#include "tests/engine/fits/turned_parts.h"

namespace glissade::test {

/// A screw whose thread is modelled as a helix, along z; its head's lower side is at 0, its tip at -`length`.
struct ThreadedScrew {
  double crest = 0.0025;
  double root = 0.00198;
  double pitch = 0.0008;
  double length = 0.008;
  double shank = 0.0;    ///< length without a thread below the head
  double chamfer = 0.0;  ///< chamfer of the tip
  int directions = 36;

  /// Radius of the thread: flat crests and roots extend an eighth of the pitch to either side of their middle.
  double radiusAt(double z, double angle) const {
    const double turn = z / pitch - angle / (2.0 * kHalfTurn);
    const double fromCrest = std::abs(turn - std::round(turn));
    const double down = std::clamp((fromCrest - 0.125) / 0.25, 0.0, 1.0);
    return std::min(crest + (root - crest) * down, crest - chamfer + (z + length));
  }

  TriangleMesh mesh() const {
    std::vector<Station> stations{{-length, circle(0.0)}};
    for (double z = -length; z < -shank - 1e-9; z += pitch / 8.0) {
      stations.push_back({z, [this, z](double angle) { return radiusAt(z, angle); }});
    }
    stations.push_back({-shank, circle(crest)});
    if (shank > 0.0) stations.push_back({0.0, circle(crest)});
    stations.push_back({0.0, circle(1.8 * crest)});
    stations.push_back({1.2 * crest, circle(1.8 * crest)});
    stations.push_back({1.2 * crest, circle(0.0)});
    TriangleMesh made = turnedMesh(stations, false, directions);
    stateFaces(made);
    return made;
  }

 private:
  /// Adds faces as in a CAD file: crest and root are cylinders, all others are free faces.
  void stateFaces(TriangleMesh& made) const {
    made.faces = {SurfaceFace{}, SurfaceFace{}, SurfaceFace{}};
    for (const int face : {1, 2}) {
      made.faces[face].kind = SurfaceFace::Kind::Cylinder;
      made.faces[face].radius = face == 1 ? crest : root;
    }
    for (const TriangleIndices& triangle : made.triangles) {
      const auto isAt = [&](double radius) {
        return std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t v) {
          return std::abs(made.vertices[v].head<2>().norm() - radius) < 1e-9;
        });
      };
      const bool isSide = std::abs(faceNormal(made, triangle).z()) < 0.5;
      made.faceOf.push_back(isSide && isAt(crest) ? 1 : isSide && isAt(root) ? 2 : 0);
    }
  }
};

/// A nut with a plain hole; its outside is a hexagon of 8 mm.
inline TriangleMesh plainNut(double hole, double low, double high) {
  return tubeMesh(circle(hole), prism(0.008, 6), low, high);
}

}  // namespace glissade::test
