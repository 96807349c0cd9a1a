#include "engine/access/loft.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace glissade {
namespace {

constexpr std::uint32_t kRingSides = 14;
constexpr int kCapRings = 3;  ///< number of rings of each round end

/// Two unit vectors across the direction; their product is the direction.
std::pair<Vector3, Vector3> across(const Vector3& direction) {
  const Vector3 a = direction.unitOrthogonal();
  return {a, direction.cross(a)};
}

/// Closes an end by a fan about its middle.
void close(TriangleMesh& mesh, const Vector3& middle, std::uint32_t first, bool atEnd) {
  const auto centre = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back(middle);
  for (std::uint32_t i = 0; i < kRingSides; ++i) {
    const std::uint32_t one = first + i;
    const std::uint32_t next = first + (i + 1) % kRingSides;
    mesh.triangles.push_back(atEnd ? TriangleIndices{centre, one, next} : TriangleIndices{centre, next, one});
  }
}

}  // namespace

TriangleMesh loft(const std::vector<LoftRing>& rings) {
  TriangleMesh mesh;
  for (const LoftRing& ring : rings) {
    for (std::uint32_t i = 0; i < kRingSides; ++i) {
      const double at = 2.0 * std::numbers::pi * i / kRingSides;
      mesh.vertices.emplace_back(ring.middle + std::cos(at) * ring.a + std::sin(at) * ring.b);
    }
  }
  const auto count = static_cast<std::uint32_t>(rings.size());
  for (std::uint32_t ring = 0; ring + 1 < count; ++ring) {
    for (std::uint32_t i = 0; i < kRingSides; ++i) {
      const std::uint32_t one = ring * kRingSides + i;
      const std::uint32_t next = ring * kRingSides + (i + 1) % kRingSides;
      mesh.triangles.push_back({one, next, next + kRingSides});
      mesh.triangles.push_back({one, next + kRingSides, one + kRingSides});
    }
  }
  close(mesh, rings.front().middle, 0, false);
  close(mesh, rings.back().middle, (count - 1) * kRingSides, true);
  return mesh;
}

TriangleMesh taperedLimb(const Vector3& from, double fromRadius, const Vector3& to, double toRadius) {
  const double length = (to - from).norm();
  const Vector3 way = (to - from) / length;
  const auto sides = across(way);
  // The hull touches the balls where its side is at right angles to their radius.
  const double tilt = std::asin(std::clamp((fromRadius - toRadius) / length, -1.0, 1.0));
  const double quarter = 0.5 * std::numbers::pi;
  constexpr double kTip = 0.15;  // angle from the pole within which an end is flat, radians
  std::vector<LoftRing> rings;
  const auto add = [&](const Vector3& middle, double radius, double latitude) {
    const double r = radius * std::cos(latitude);
    rings.push_back({middle + radius * std::sin(latitude) * way, r * sides.first, r * sides.second});
  };
  for (int i = 0; i <= kCapRings; ++i) add(from, fromRadius, -quarter + kTip + (quarter - kTip + tilt) * i / kCapRings);
  for (int i = 0; i <= kCapRings; ++i) add(to, toRadius, tilt + (quarter - kTip - tilt) * i / kCapRings);
  return loft(rings);
}

}  // namespace glissade
