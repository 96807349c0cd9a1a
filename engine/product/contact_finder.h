#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "engine/geometry/triangle_tree.h"
#include "engine/product/contact_report.h"
#include "engine/product/overlap_depth.h"
#include "engine/product/surface_regions.h"

namespace glissade {

/// A body prepared for comparing it with others, in the world frame.
struct PreparedBody {
  TriangleMesh mesh;
  TriangleTree tree;
  SurfaceRegions regions;
  double deflection = 0.0;  ///< as of ContactBody
  double deviation = 0.0;   ///< metres that any of its triangles may be off the true surface
  mutable std::optional<std::optional<SolidDepth>> solid;  ///< once it was needed

  PreparedBody(TriangleMesh mesh_W, SurfaceRegions regions_W, double deflection_);

  /// Null where the mesh is not closed.
  const SolidDepth* depth() const;
  /// Metres that triangles of this label may be off the true surface.
  double deviationOf(const SurfaceRegions::Label& label) const;
};

/// What two bodies have to do with each other; nothing where they are farther apart than `limits.clearanceUpTo`.
/// Indices of the contact are left 0.
std::optional<Contact> contactOf(const PreparedBody& a, const PreparedBody& b, const ContactLimits& limits);

}  // namespace glissade
