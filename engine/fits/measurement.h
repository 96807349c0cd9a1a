#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/fits/surface_regions.h"

namespace glissade {

/// A feature of a body that a person points at.
struct MeasureFeature {
  enum class Kind { Vertex, Edge, Face, Cylinder, Cone, Sphere, Torus, FreeFace };
  Kind kind = Kind::FreeFace;
  Vector3 picked = Vector3::Zero();  ///< point on the feature; for a vertex the vertex
  Vector3 from = Vector3::Zero();    ///< ends of an edge
  Vector3 to = Vector3::Zero();
  Vector3 direction = Vector3::UnitZ();  ///< unit: direction of an edge or an axis, normal of a face
  Vector3 axisPoint = Vector3::Zero();   ///< on the axis, beside `picked`; or the centre of a sphere or a torus
  double radius = 0.0;  ///< metres: radius of a cylinder, of a cone beside `picked`, of a sphere, of a torus's circle
  double halfAngle = 0.0;   ///< angle of a cone between its axis and its lines, radians
  double tubeRadius = 0.0;  ///< radius of a torus's tube, metres
  bool isHole = false;      ///< for a Cylinder and the kinds after it: the material is outside

  /// True if it has an axis: a cylinder, a cone or a torus.
  bool isTurned() const { return kind == Kind::Cylinder || kind == Kind::Cone || kind == Kind::Torus; }
};

/// The feature of a body at X_WB in the world.
MeasureFeature placed(const MeasureFeature& feature, const Pose& X_WB);

/// A mesh with its planes, cylinders and feature edges. Immutable. Construction takes seconds for a million triangles.
class MeasurableMesh {
 public:
  explicit MeasurableMesh(MeshPtr mesh);

  /// The feature at a point of a triangle: a vertex or a feature edge of the triangle within `snap` metres, else the
  /// surface. In the mesh's frame.
  MeasureFeature featureAt(std::size_t triangle, const Vector3& p, double snap) const;

  /// The feature for an alignment: featureAt(), with the circular edge of a cylinder, a cone or a torus replaced by
  /// that surface.
  MeasureFeature alignableAt(std::size_t triangle, const Vector3& p, double snap) const;

  /// The border of the plane or the round surface that contains the triangle: two points for each segment, in the
  /// mesh's frame. Empty on free surfaces.
  std::vector<Vector3> outlineAt(std::size_t triangle) const;

  /// A frame for placing the body by the plane or the round surface that contains the triangle, in the mesh's frame.
  /// Origin: the centre of the face, or of the part of the axis beside it; the centre of a sphere or a torus. z: the
  /// outward normal, or the axis, with its largest coordinate positive. x: as near as possible to x, or to y if z is
  /// near x. Nothing on free surfaces.
  std::optional<Pose> frameAt(std::size_t triangle) const;

  const TriangleMesh& mesh() const { return *mesh_; }
  const SurfaceRegions& regions() const { return regions_; }

 private:
  /// A triangle at an edge; the vertices of the edge are in ascending order.
  struct EdgeSide {
    std::uint32_t low;
    std::uint32_t high;
    std::uint32_t triangle;
  };
  struct EdgeSides {
    const EdgeSide* first;
    const EdgeSide* last;
  };

  EdgeSides sidesOf(std::uint32_t a, std::uint32_t b) const;
  bool isFeatureEdge(const EdgeSides& sides) const;
  bool isFeatureEdge(std::uint32_t a, std::uint32_t b) const { return isFeatureEdge(sidesOf(a, b)); }
  /// The cylinder, cone or torus whose circular edge this is; nothing if there is none.
  std::optional<SurfaceRegions::Label> rimOf(std::uint32_t a, std::uint32_t b) const;
  /// The direction of the axis; nothing if there is none.
  std::optional<Vector3> axisOf(const SurfaceRegions::Label& label) const;
  /// The feature of a round surface at this point.
  MeasureFeature roundAt(const SurfaceRegions::Label& label, const Vector3& p) const;

  MeshPtr mesh_;
  SurfaceRegions regions_;
  std::vector<EdgeSide> sides_;  ///< in the order of their edges
};

/// A distance, with its two end points.
struct MeasuredDistance {
  double metres = 0.0;
  Vector3 from = Vector3::Zero();
  Vector3 to = Vector3::Zero();
};

/// The distance of two features. Vertices and edges are taken as they are, faces as infinite planes, cylinders, cones
/// and tori as their axes, spheres as their centres, points of free surfaces as points. Faces that are not parallel,
/// and features that cross a plane, have the distance 0. Both in the same frame.
MeasuredDistance distanceBetween(const MeasureFeature& a, const MeasureFeature& b);

/// Angle from 0 to pi / 2, radians: between edges and axes, between the planes of faces, or between an edge and a face.
/// Nothing if one of the two has no direction.
std::optional<double> angleBetweenFeatures(const MeasureFeature& a, const MeasureFeature& b);

}  // namespace glissade
