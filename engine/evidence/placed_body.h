#pragma once

#include <optional>
#include <vector>

#include "engine/evidence/body.h"
#include "engine/evidence/face_regions.h"
#include "engine/evidence/round_faces.h"
#include "engine/geometry/solid_interior.h"
#include "engine/geometry/triangle_tree.h"

namespace glissade::evidence {

/// Two faces face each other if the cosine between their normals is below this. Faces beside touching faces do not.
inline constexpr double kFacing = -0.3;

/// A placed body, prepared for comparisons with others. Immutable, shared by threads.
struct PlacedBody {
  PlacedBody(const Body& body, const Pose& X_WB);

  TriangleMesh mesh;  ///< world frame
  TriangleTree tree;
  FaceRegions regions;
  std::optional<SolidInterior> interior;  ///< nothing if the surface is not closed
  std::vector<Vector3> normals;           ///< unit, outwards; zero for a triangle without area
  std::vector<double> deflections;        ///< one entry for each triangle, metres
  double largestDeflection = 0.0;         ///< metres
  double spacing = 0.0;
  double radius = 0.0;        ///< radius about the frame of the mesh, metres
  double halfDiagonal = 0.0;  ///< half diagonal of the box along the axes of the mesh, metres
  std::vector<RoundFace> rounds{};

  bool contains(const Vector3& p) const { return interior && interior->contains(p); }
};

}  // namespace glissade::evidence
