#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "engine/base/reserve_filled.h"
#include "engine/geometry/pose.h"

namespace glissade {

/// Gives equal positions the same index, in the order of their first appearance. Positions are equal if all their
/// coordinates are; -0 equals 0. Coordinates are not NaN.
class VertexWelder {
 public:
  /// `expected`: expected number of positions; more are accepted, too.
  explicit VertexWelder(std::size_t expected = 0) {
    const std::size_t slots = std::bit_ceil(std::max(kFewest, 2 * (expected + 1)));
    reserveFilled(slots_, slots);
    slots_.assign(slots, kFree);
    reserveFilled(vertices_, expected);
  }

  std::uint32_t indexOf(const Vector3& position) {
    if (2 * (vertices_.size() + 1) > slots_.size()) grow();
    std::uint32_t& slot = slotOf(position);
    if (slot == kFree) {
      slot = static_cast<std::uint32_t>(vertices_.size());
      vertices_.push_back(position);
    }
    return slot;
  }

  const std::vector<Vector3>& vertices() const { return vertices_; }
  std::vector<Vector3> takeVertices() && { return std::move(vertices_); }

 private:
  static constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::size_t kFewest = 64;

  static std::uint64_t mixed(std::uint64_t hash, double coordinate) {
    hash ^= std::bit_cast<std::uint64_t>(coordinate + 0.0);  // + 0.0 turns -0 into 0
    hash *= 0x9e3779b97f4a7c15U;
    return hash ^ (hash >> 32U);
  }

  /// The slot that holds the position, or the free one for it. The number of slots is a power of two.
  std::uint32_t& slotOf(const Vector3& position) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = mixed(mixed(mixed(0, position.x()), position.y()), position.z()) & mask;
    while (slots_[at] != kFree && vertices_[slots_[at]] != position) at = (at + 1) & mask;
    return slots_[at];
  }

  void grow() {
    slots_.assign(2 * slots_.size(), kFree);
    for (std::size_t i = 0; i < vertices_.size(); ++i) slotOf(vertices_[i]) = static_cast<std::uint32_t>(i);
  }

  std::vector<std::uint32_t> slots_;
  std::vector<Vector3> vertices_;
};

}  // namespace glissade
