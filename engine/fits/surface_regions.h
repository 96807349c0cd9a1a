#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/surface_face.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// A plane of connected triangles of a mesh: normal . p = offset.
struct PlaneRegion {
  Vector3 normal;  ///< unit, outwards
  double offset = 0.0;
};

/// A cylinder that contains the vertices of connected triangles of a mesh.
struct CylinderRegion {
  Vector3 point;      ///< on the axis
  Vector3 direction;  ///< unit
  double radius = 0.0;
  bool shaft = false;  ///< true: the material is inside (a shaft); false: a hole
  double low = 0.0;    ///< range along the axis from `point`
  double high = 0.0;
  double sagitta = 0.0;  ///< largest distance of the triangles from the cylinder, metres
};

/// A cone, a sphere or a torus that the file states for connected triangles of a mesh.
struct RoundRegion {
  SurfaceFace surface;  ///< the axis of a cone points to its wider end
  bool shaft = false;   ///< the material is on the side of the axis, the centre or the circle
  double low = 0.0;     ///< range along the axis from the surface's point
  double high = 0.0;
  double sagitta = 0.0;  ///< largest distance of the triangles from the surface, metres
};

/// Radius of a cone at a height along its axis, from the surface's point.
double coneRadiusAt(const SurfaceFace& cone, double height);

/// Planes, cylinders and other round surfaces of a mesh. A triangle in none of them belongs to a free surface.
struct SurfaceRegions {
  enum class Kind : std::uint8_t { Free, Plane, Cylinder, Round };
  struct Label {
    Kind kind = Kind::Free;
    std::uint32_t index = 0;  ///< index in `planes`, `cylinders` or `rounds`; 0 for a free surface

    bool operator==(const Label&) const = default;
  };
  std::vector<PlaneRegion> planes;
  std::vector<CylinderRegion> cylinders;
  std::vector<RoundRegion> rounds;
  std::vector<Label> labels;  ///< one entry for each triangle
};

/// Takes the planes, cylinders, cones, spheres and tori that the file states for the mesh's faces. If the file states
/// nothing for a face (a mesh file, a spline), planes and cylinders are fitted to connected triangles by growing
/// regions over edges. Vertices that an exporter put on a cylinder give its exact radius, however coarse the triangles;
/// a prism with fewer than ten sides a turn is no cylinder. A statement that the triangles contradict is not used.
/// Precondition: the mesh is welded.
SurfaceRegions findSurfaceRegions(const TriangleMesh& mesh);

/// The regions of the mesh placed at X_WB.
SurfaceRegions transformed(SurfaceRegions regions, const Pose& X_WB);

}  // namespace glissade
