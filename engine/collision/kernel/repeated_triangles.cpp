#include "engine/collision/kernel/repeated_triangles.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

namespace glissade {
namespace {

/// Of a corner. Zero has two signs and one place.
std::uint64_t mixed(const Vector3& corner) {
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    key = (key ^ std::bit_cast<std::uint64_t>(corner[axis] + 0.0)) * 0x9E3779B97F4A7C15U;
    key ^= key >> 32U;
  }
  return key;
}

/// The same for the same corners in any order.
std::uint64_t keyOf(const OwnedTriangle& triangle) {
  return mixed(triangle.corners[0]) + mixed(triangle.corners[1]) + mixed(triangle.corners[2]);
}

bool sameCorners(const Triangle& a, const Triangle& b) {
  constexpr std::array<std::array<std::size_t, 3>, 6> kOrders{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  return std::any_of(kOrders.begin(), kOrders.end(), [&](const auto& order) {
    return a[0] == b[order[0]] && a[1] == b[order[1]] && a[2] == b[order[2]];
  });
}

}  // namespace

void dropRepeated(std::vector<OwnedTriangle>& triangles) {
  std::vector<std::pair<std::uint64_t, std::size_t>> keys;
  keys.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) keys.emplace_back(keyOf(triangles[i]), i);
  std::sort(keys.begin(), keys.end());
  std::vector<bool> repeated(triangles.size(), false);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const OwnedTriangle& first = triangles[keys[i].second];
    if (repeated[keys[i].second]) continue;
    for (std::size_t k = i + 1; k < keys.size() && keys[k].first == keys[i].first; ++k) {
      const OwnedTriangle& other = triangles[keys[k].second];
      if (other.body == first.body && sameCorners(first.corners, other.corners)) repeated[keys[k].second] = true;
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (!repeated[i]) triangles[kept++] = triangles[i];
  }
  triangles.resize(kept);
}

}  // namespace glissade
