#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/geometry/triangle_mesh.h"

namespace glissade::nut_and_bolt {

/// Pitch of an M10 thread, metres.
inline constexpr double kPitch = 0.0015;
/// Vertices in a turn, and layers of vertices in a pitch; edges follow the helix.
inline constexpr int kSteps = 32;

/// Parameters of the threads, metres.
struct Shape {
  double pitch = kPitch;  ///< below 0: left-handed
  double play = 0.0003;   ///< radial play
  int boltTurns = 8;
  int nutTurns = 3;
};

/// Distance from the axis of a thread's surface: a trapezoid with flanks of 65 degrees to the axis, by quarters of a
/// pitch: root, flank, crest, flank.
inline double radiusAt(int step, double play) {
  constexpr double kRoot = 0.0042;
  constexpr double kCrest = 0.005;
  const int inPitch = (step % kSteps + kSteps) % kSteps;
  const double quarters = 4.0 * inPitch / kSteps;
  const double share = quarters < 2.0 ? quarters - 1.0 : 4.0 - quarters;
  return kRoot + play + std::clamp(share, 0.0, 1.0) * (kCrest - kRoot);
}

/// Rings of vertices about z, joined by triangles. Faces point outwards if rings go up.
class Rings {
 public:
  /// `radius(i)` at angle 2 pi i / kSteps.
  template <class Radius>
  std::uint32_t add(double z, const Radius& radius) {
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (int i = 0; i < kSteps; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kSteps;
      mesh_.vertices.emplace_back(radius(i) * std::cos(angle), radius(i) * std::sin(angle), z);
    }
    return first;
  }
  /// The band from one ring to the next one; `shift`: its diagonals run up with the angle (1) or down (-1).
  void join(std::uint32_t low, std::uint32_t high, int shift = 1) {
    for (std::uint32_t i = 0; i < kSteps; ++i) {
      const std::uint32_t next = (i + 1) % kSteps;
      if (shift > 0) {
        mesh_.triangles.push_back({low + i, low + next, high + next});
        mesh_.triangles.push_back({low + i, high + next, high + i});
      } else {
        mesh_.triangles.push_back({low + i, low + next, high + i});
        mesh_.triangles.push_back({low + next, high + next, high + i});
      }
    }
  }
  /// A cap with a vertex on the axis; `sense` 1: seen from above.
  void cap(std::uint32_t ring, double z, int sense) {
    const auto middle = static_cast<std::uint32_t>(mesh_.vertices.size());
    mesh_.vertices.emplace_back(0.0, 0.0, z);
    for (std::uint32_t i = 0; i < kSteps; ++i) {
      const std::uint32_t next = (i + 1) % kSteps;
      mesh_.triangles.push_back(sense > 0 ? TriangleIndices{ring + i, ring + next, middle}
                                          : TriangleIndices{ring + next, ring + i, middle});
    }
  }
  TriangleMesh take() { return std::move(mesh_); }

 private:
  TriangleMesh mesh_;
};

inline double hexagonAt(int i, double flat) {
  const double sixth = std::numbers::pi / 3.0;
  const double angle = 2.0 * std::numbers::pi * i / kSteps;
  const double fromFlat = angle - (std::floor(angle / sixth + 1e-9) + 0.5) * sixth;
  return flat / std::cos(fromFlat);
}

/// The rings of a thread, from z = 0 upwards; returns the first and the last.
inline std::pair<std::uint32_t, std::uint32_t> addThread(Rings& rings, const Shape& shape, int turns, double play,
                                                         bool upwards) {
  const int hand = shape.pitch < 0.0 ? -1 : 1;
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  for (int layer = 0; layer <= turns * kSteps; ++layer) {
    const std::uint32_t ring =
        rings.add(std::abs(shape.pitch) * layer / kSteps, [&](int i) { return radiusAt(layer - hand * i, play); });
    if (layer == 0) {
      first = ring;
    } else if (upwards) {
      rings.join(last, ring, hand);
    } else {
      rings.join(ring, last, -hand);
    }
    last = ring;
  }
  return {first, last};
}

/// A bolt along z: the thread from z = 0 upwards, the head below.
inline TriangleMesh bolt(const Shape& shape = {}) {
  constexpr double kHead = 0.006;
  constexpr double kHeadRadius = 0.008;
  Rings rings;
  const auto wide = [](int) { return kHeadRadius; };
  const std::uint32_t below = rings.add(-kHead, wide);
  const std::uint32_t above = rings.add(0.0, wide);
  rings.cap(below, -kHead, -1);
  rings.join(below, above);
  const auto [first, last] = addThread(rings, shape, shape.boltTurns, 0.0, true);
  rings.join(above, first);
  rings.cap(last, std::abs(shape.pitch) * shape.boltTurns, 1);
  return rings.take();
}

/// A hexagonal nut about z, from z = 0 upwards. Whole pitches up, and with the same orientation as the bolt, it is in
/// the middle of its play.
inline TriangleMesh nut(const Shape& shape = {}) {
  constexpr double kFlat = 0.008;
  Rings rings;
  const double top = std::abs(shape.pitch) * shape.nutTurns;
  const auto [first, last] = addThread(rings, shape, shape.nutTurns, shape.play, false);
  const auto hexagon = [](int i) { return hexagonAt(i, kFlat); };
  const std::uint32_t below = rings.add(0.0, hexagon);
  const std::uint32_t above = rings.add(top, hexagon);
  rings.join(first, below);
  rings.join(below, above);
  rings.join(above, last);
  return rings.take();
}

}  // namespace glissade::nut_and_bolt
