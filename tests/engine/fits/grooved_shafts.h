#pragma once

#include <cmath>
#include <functional>

#include "tests/engine/fits/turned_parts.h"

namespace glissade::test {

/// Distance of a surface from the z axis at a height and in a direction (radians).
using Relief = std::function<double(double, double)>;

/// Flat crests and roots: 1 on a crest, 0 on a root. `turn`: 0 in the middle of a crest, 1 in that of the next one.
inline double toothAt(double turn) {
  const double fromCrest = std::abs(turn - std::round(turn));
  return 1.0 - std::clamp((fromCrest - 0.1) / 0.3, 0.0, 1.0);
}

/// A thread of so many starts; `pitch` of the turn, below 0: left-handed.
inline Relief helix(double crest, double root, double pitch, int starts = 1) {
  return [=](double z, double angle) {
    return root + (crest - root) * toothAt(starts * (z / pitch - angle / (2.0 * kHalfTurn)));
  };
}

inline Relief rings(double crest, double root, double pitch) {
  return [=](double z, double) { return root + (crest - root) * toothAt(z / pitch); };
}

/// Cones with their wide ends up: they go in, and not out.
inline Relief barbs(double crest, double root, double pitch) {
  return [=](double z, double) { return root + (crest - root) * (z / pitch - std::floor(z / pitch)); };
}

/// Teeth along the axis.
inline Relief straightKnurl(double crest, double root, int teeth) {
  return [=](double, double angle) { return root + (crest - root) * toothAt(teeth * angle / (2.0 * kHalfTurn)); };
}

inline Relief diamondKnurl(double crest, double root, double pitch, int teeth) {
  return [=](double z, double angle) {
    const double around = teeth * angle / (2.0 * kHalfTurn);
    return root + (crest - root) * toothAt(around + z / pitch) * toothAt(around - z / pitch);
  };
}

inline Relief smooth(double radius) {
  return [=](double, double) { return radius; };
}

/// One groove for a ring, in the middle of the length.
inline Relief ringGroove(double radius, double root, double middle, double width) {
  return [=](double z, double) { return std::abs(z - middle) < 0.5 * width ? root : radius; };
}

/// The head of a shaft: none, one without a drive, or one with a hexagon.
enum class ShaftHead { None, Round, Hexagon };

/// A shaft from -`length` to 0, its head above. All of it is one free face of a CAD file.
inline TriangleMesh groovedShaft(const Relief& relief, double length, double radius, ShaftHead head = ShaftHead::None,
                                 int levels = 64, int directions = 48) {
  std::vector<Station> stations{{-length, circle(0.0)}};
  for (int i = 0; i <= levels; ++i) {
    const double z = -length + length * i / levels;
    stations.push_back({z, [relief, z](double angle) { return relief(z, angle); }});
  }
  if (head != ShaftHead::None) {
    const Contour wide = head == ShaftHead::Round ? circle(1.8 * radius) : prism(3.4 * radius, 6);
    stations.push_back({0.0, wide});
    stations.push_back({1.2 * radius, wide});
    stations.push_back({1.2 * radius, circle(0.0)});
  } else {
    stations.push_back({0.0, circle(0.0)});
  }
  TriangleMesh mesh = turnedMesh(stations, false, directions);
  mesh.faces = {SurfaceFace{}};
  mesh.faceOf.assign(mesh.triangles.size(), 0);
  return mesh;
}

}  // namespace glissade::test
