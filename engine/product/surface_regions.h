#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/surface_face.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// A plane that connected triangles of a mesh lie in: normal . p = offset.
struct PlaneRegion {
  Vector3 normal;  ///< unit, outwards
  double offset = 0.0;
};

/// A cylinder that the vertices of connected triangles of a mesh lie on.
struct CylinderRegion {
  Vector3 point;      ///< on the axis
  Vector3 direction;  ///< unit
  double radius = 0.0;
  bool shaft = false;    ///< the material is inside: a shaft; else a hole
  double low = 0.0;      ///< extent along the axis from `point`
  double high = 0.0;     ///< likewise
  double sagitta = 0.0;  ///< metres that the triangles are off the cylinder, at most
};

/// A cone, a sphere or a torus that the file states of connected triangles of a mesh.
struct RoundRegion {
  SurfaceFace surface;   ///< the axis of a cone points to where it is wider
  bool shaft = false;    ///< the material is on the side of the axis, the centre or the circle
  double low = 0.0;      ///< extent along the axis from the surface's point
  double high = 0.0;     ///< likewise
  double sagitta = 0.0;  ///< metres that the triangles are off the surface, at most
};

/// Radius of a cone beside a height along its axis, from the surface's point.
double coneRadiusAt(const SurfaceFace& cone, double height);

/// Planes, cylinders and other round surfaces of a mesh. Where a triangle is in none it belongs to a free surface.
struct SurfaceRegions {
  enum class Kind : std::uint8_t { Free, Plane, Cylinder, Round };
  struct Label {
    Kind kind = Kind::Free;
    std::uint32_t index = 0;  ///< into `planes`, `cylinders` or `rounds`; 0 of a free surface

    bool operator==(const Label&) const = default;
  };
  std::vector<PlaneRegion> planes;
  std::vector<CylinderRegion> cylinders;
  std::vector<RoundRegion> rounds;
  std::vector<Label> labels;  ///< of each triangle
};

/// The planes, cylinders, cones, spheres and tori that the file states of the mesh's faces, as they are. Where the file
/// states nothing of a face (a mesh file, a spline) planes and cylinders are fitted to connected triangles by growing
/// regions over edges: vertices that an exporter put on a cylinder give its exact radius, however coarse the triangles
/// are, and a prism with fewer than ten sides a turn is not taken as a cylinder. A statement that the triangles
/// contradict is not used. The mesh must be welded.
SurfaceRegions findSurfaceRegions(const TriangleMesh& mesh);

/// The regions of the mesh placed at X_WB.
SurfaceRegions transformed(SurfaceRegions regions, const Pose& X_WB);

}  // namespace glissade
