#pragma once

#include <cmath>

#include "engine/geometry/triangle_mesh.h"

namespace glissade::test {

/// A ring along z about the origin whose vertices lie on its two cylinders; inner radius 0: a cylinder.
inline TriangleMesh makeRing(double inner, double outer, double length, int segments) {
  TriangleMesh mesh;
  const auto count = static_cast<std::uint32_t>(segments);
  const auto addCircle = [&](double radius, double z) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const double angle = 2.0 * 3.14159265358979323846 * i / segments;
      mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  };
  const auto addBand = [&](std::uint32_t low, std::uint32_t high) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t k = (i + 1) % count;
      mesh.triangles.push_back({low + i, low + k, high + i});
      mesh.triangles.push_back({high + i, low + k, high + k});
    }
  };
  addCircle(outer, -0.5 * length);
  addCircle(outer, 0.5 * length);
  addBand(0, count);
  if (inner > 0.0) {
    addCircle(inner, 0.5 * length);
    addCircle(inner, -0.5 * length);
    addBand(count, 2 * count);
    addBand(2 * count, 3 * count);
    addBand(3 * count, 0);
    return mesh;
  }
  const auto addFan = [&](std::uint32_t first, double z, bool up) {
    const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(0.0, 0.0, z);
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t a = first + i;
      const std::uint32_t b = first + (i + 1) % count;
      mesh.triangles.push_back(up ? TriangleIndices{middle, a, b} : TriangleIndices{middle, b, a});
    }
  };
  addFan(0, -0.5 * length, false);
  addFan(count, 0.5 * length, true);
  return mesh;
}

}  // namespace glissade::test
