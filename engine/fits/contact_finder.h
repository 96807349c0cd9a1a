#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "engine/fits/contact_report.h"
#include "engine/fits/overlap_depth.h"
#include "engine/fits/surface_regions.h"
#include "engine/geometry/triangle_tree.h"

namespace glissade {

/// A body prepared for comparisons with others, in the world frame. Shared by threads.
struct PreparedBody {
  TriangleMesh mesh;
  TriangleTree tree;
  SurfaceRegions regions;
  double deflection = 0.0;  ///< see ContactBody::deflection
  double deviation = 0.0;   ///< largest deviation of its triangles from the true surface, metres

  PreparedBody(TriangleMesh mesh_W, SurfaceRegions regions_W, double deflection_);

  /// Null if the mesh is not closed.
  const SolidDepth* depth() const;
  /// Largest deviation of triangles of this label from the true surface, metres.
  double deviationOf(const SurfaceRegions::Label& label) const;

 private:
  mutable std::once_flag isAsked_;
  mutable std::optional<SolidDepth> solid_;  ///< made at the first call of depth()
};

/// The contact of two bodies; nothing if they are farther apart than `limits.clearanceUpTo`. Indices of the contact are
/// left 0.
std::optional<Contact> contactOf(const PreparedBody& a, const PreparedBody& b, const ContactLimits& limits);

}  // namespace glissade
