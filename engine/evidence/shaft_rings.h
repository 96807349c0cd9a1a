#pragma once

#include <cstdint>
#include <vector>

#include "engine/evidence/placed_body.h"
#include "engine/geometry/range.h"

namespace glissade::evidence {

/// A vertex on the line between two earlier vertices of a mesh.
struct NewVertex {
  std::uint32_t from;
  std::uint32_t to;
  double share;  ///< of the line, from `from`
};

/// The triangles of a mesh after some of them were divided. The surface is the same.
struct DividedTriangles {
  std::vector<NewVertex> newVertices{};  ///< vertices that follow those of the mesh
  std::vector<TriangleIndices> triangles{};
  std::vector<std::uint32_t> parents{};  ///< triangle of the mesh, of each triangle

  /// The vertices of the divided mesh. `whole`: those of the mesh, in any frame.
  std::vector<Vector3> vertices(const std::vector<Vector3>& whole) const;
};

/// Parts of a shaft, each between two heights along its axis, metres from its point.
struct ShaftRings {
  RoundFace shaft;
  std::vector<Range> rings;  ///< ascending; no two of them overlap
};

/// The parts of shafts of the body that are in coaxial holes of the other body, with so many metres beside the holes.
std::vector<ShaftRings> ringsInHoles(const PlacedBody& body, const PlacedBody& other, double beside);

/// Divides the triangles of shafts at both ends of each ring, and so many metres on both sides of each end. A cut
/// across a shaft adds four triangles a facet at most. Nothing is cut near a corner of the shaft, or where the shaft
/// shares a cut edge with another face.
DividedTriangles dividedAtRings(const PlacedBody& body, const std::vector<ShaftRings>& rings, double beside);

}  // namespace glissade::evidence
