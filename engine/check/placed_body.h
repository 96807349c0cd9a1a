#pragma once

#include <optional>
#include <vector>

#include "engine/check/body.h"
#include "engine/check/face_regions.h"
#include "engine/check/round_faces.h"
#include "engine/geometry/solid_interior.h"
#include "engine/geometry/triangle_tree.h"

namespace glissade::check {

/// Cosine between the normals of two faces: below it they face each other. Faces beside those that touch do not.
inline constexpr double kFacing = -0.3;

/// A body where the product is assembled, prepared for being compared with others. Immutable, shared by threads.
struct PlacedBody {
  PlacedBody(const Body& body, const Pose& X_WB);

  TriangleMesh mesh;  ///< world frame
  TriangleTree tree;
  FaceRegions regions;
  std::optional<SolidInterior> interior;  ///< nothing where the surface is not closed
  std::vector<Vector3> normals;           ///< unit, outwards; zero of a triangle without area
  std::vector<double> deflections;        ///< of each triangle, metres
  double largestDeflection = 0.0;         ///< of all triangles, metres
  double spacing = 0.0;
  double radius = 0.0;        ///< about the frame of the mesh, metres
  double halfDiagonal = 0.0;  ///< of the box along the axes of the mesh, metres
  std::vector<RoundFace> rounds{};

  bool contains(const Vector3& p) const { return interior && interior->contains(p); }
};

}  // namespace glissade::check
