#pragma once

#include <vector>

#include "engine/geometry/pose.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade::made {

/// Corners of a section in x and y, counter-clockwise.
using Section = std::vector<Eigen::Vector2d>;

/// Frames along a line: z is the direction of the line, sections are in x and y.
using Frames = std::vector<Pose>;

namespace swept {

inline void addRings(const Frames& frames, const Section& section, TriangleMesh& mesh) {
  for (const Pose& frame : frames) {
    for (const Eigen::Vector2d& corner : section) mesh.vertices.push_back(frame * Vector3(corner.x(), corner.y(), 0.0));
  }
}

inline void addQuad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, TriangleMesh& mesh) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

/// The sides between rings of `count` vertices; `first` is the first vertex of the first ring.
inline void addSides(std::uint32_t first, std::uint32_t count, std::size_t rings, bool outside, TriangleMesh& mesh) {
  for (std::size_t ring = 0; ring + 1 < rings; ++ring) {
    const auto low = first + static_cast<std::uint32_t>(ring) * count;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t k = (i + 1) % count;
      if (outside) {
        addQuad(low + i, low + k, low + count + k, low + count + i, mesh);
      } else {
        addQuad(low + k, low + i, low + count + i, low + count + k, mesh);
      }
    }
  }
}

}  // namespace swept

/// A convex section swept along the frames, closed at both ends.
inline TriangleMesh solidAlong(const Frames& frames, const Section& section) {
  TriangleMesh mesh;
  const auto count = static_cast<std::uint32_t>(section.size());
  swept::addRings(frames, section, mesh);
  swept::addSides(0, count, frames.size(), true, mesh);
  const auto last = static_cast<std::uint32_t>(mesh.vertices.size()) - count;
  for (std::uint32_t i = 1; i + 1 < count; ++i) {
    mesh.triangles.push_back({0, i + 1, i});
    mesh.triangles.push_back({last, last + i, last + i + 1});
  }
  return mesh;
}

/// The volume between two sections with equal numbers of corners, swept along the frames: a pipe with a bore that is
/// open at both ends.
inline TriangleMesh tubeAlong(const Frames& frames, const Section& inner, const Section& outer) {
  TriangleMesh mesh;
  const auto count = static_cast<std::uint32_t>(inner.size());
  swept::addRings(frames, outer, mesh);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  swept::addRings(frames, inner, mesh);
  swept::addSides(0, count, frames.size(), true, mesh);
  swept::addSides(first, count, frames.size(), false, mesh);
  const auto last = first - count;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t k = (i + 1) % count;
    swept::addQuad(i, first + i, first + k, k, mesh);
    swept::addQuad(last + k, last + first + k, last + first + i, last + i, mesh);
  }
  return mesh;
}

inline Section regularSection(double radius, int corners) {
  Section section;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::acos(-1.0) * i / corners;
    section.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return section;
}

inline Section rectangularSection(double width, double height) {
  const double x = width / 2.0;
  const double y = height / 2.0;
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

}  // namespace glissade::made
