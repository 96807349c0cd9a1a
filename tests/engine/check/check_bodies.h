#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "engine/check/product.h"
#include "engine/geometry/primitives.h"

namespace glissade::test {

inline evidence::Body checkBody(const std::string& id, TriangleMesh mesh, const Vector3& at = Vector3::Zero()) {
  return {BodyId(id), id, std::make_shared<const TriangleMesh>(std::move(mesh)), Pose::translation(at)};
}

/// An upright prism with `sides` sides about z, from 0 to its height; `turn`: radians.
inline TriangleMesh prism(int sides, double radius, double height, double turn = 0.0) {
  TriangleMesh mesh;
  for (const double z : {0.0, height}) {
    for (int i = 0; i < sides; ++i) {
      const double angle = turn + 2.0 * std::numbers::pi * i / sides;
      mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  }
  mesh.vertices.emplace_back(0.0, 0.0, 0.0);
  mesh.vertices.emplace_back(0.0, 0.0, height);
  const auto n = static_cast<std::uint32_t>(sides);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    mesh.triangles.push_back({i, next, n + next});
    mesh.triangles.push_back({i, n + next, n + i});
    mesh.triangles.push_back({2 * n, next, i});
    mesh.triangles.push_back({2 * n + 1, n + i, n + next});
  }
  return mesh;
}

/// A plate with a prismatic hole of `sides` sides about z, from `low` to `high`.
inline TriangleMesh holedPlate(int sides, double radius, double outer, double low, double high) {
  TriangleMesh mesh;
  for (const double z : {low, high}) {
    for (const double r : {radius, outer}) {
      for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / sides;
        mesh.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
      }
    }
  }
  const auto n = static_cast<std::uint32_t>(sides);
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t k = (i + 1) % n;
    quad(i, 2 * n + i, 2 * n + k, k);                  // the hole's wall
    quad(n + i, n + k, 3 * n + k, 3 * n + i);          // the rim
    quad(i, k, n + k, n + i);                          // below
    quad(2 * n + i, 3 * n + i, 3 * n + k, 2 * n + k);  // above
  }
  return mesh;
}

}  // namespace glissade::test
