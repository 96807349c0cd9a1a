#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/product/surface_regions.h"

namespace glissade {

/// What a person points at on a body.
struct MeasureFeature {
  enum class Kind { Vertex, Edge, Face, Cylinder, Cone, Sphere, Torus, FreeFace };
  Kind kind = Kind::FreeFace;
  Vector3 picked = Vector3::Zero();  ///< on the feature: of a vertex itself
  Vector3 from = Vector3::Zero();    ///< of an edge
  Vector3 to = Vector3::Zero();
  Vector3 direction = Vector3::UnitZ();  ///< unit: of an edge, of an axis; of a face its normal
  Vector3 axisPoint = Vector3::Zero();  ///< of a cylinder or a cone, beside `picked`; of a sphere or a torus the centre
  double radius = 0.0;      ///< metres: of a cylinder, of a cone beside `picked`, of a sphere, of a torus's circle
  double halfAngle = 0.0;   ///< of a cone, between its axis and its lines, radians
  double tubeRadius = 0.0;  ///< of a torus, metres
  bool isHole = false;      ///< of a cylinder and of what follows it: the material is outside

  /// It has an axis: a cylinder, a cone or a torus.
  bool isTurned() const { return kind == Kind::Cylinder || kind == Kind::Cone || kind == Kind::Torus; }
};

/// The feature of a body at X_WB in the world.
MeasureFeature placed(const MeasureFeature& feature, const Pose& X_WB);

/// A mesh with its planes, cylinders and feature edges found. Immutable. Making one takes seconds for a million
/// triangles.
class MeasurableMesh {
 public:
  explicit MeasurableMesh(MeshPtr mesh);

  /// What is meant by a point on a triangle: a vertex or a feature edge of the triangle that is within `snap` metres,
  /// else the surface. In the mesh's frame.
  MeasureFeature featureAt(std::size_t triangle, const Vector3& p, double snap) const;

  /// What is meant where a body is aligned: as featureAt(), but the circular edge of a cylinder, a cone or a torus
  /// means that.
  MeasureFeature alignableAt(std::size_t triangle, const Vector3& p, double snap) const;

  /// The border of the plane or the round surface that the triangle is of: two points for each segment, in the mesh's
  /// frame. Empty on free surfaces.
  std::vector<Vector3> outlineAt(std::size_t triangle) const;

  /// A frame for placing the body by the plane or the round surface that the triangle is of, in the mesh's frame.
  /// Origin: the middle of the face, or of the part of the axis beside it; the centre of a sphere or a torus. z: the
  /// outward normal, or the axis, towards its largest coordinate. x: as near as can be to x, or to y where z is near x.
  /// Nothing on free surfaces.
  std::optional<Pose> frameAt(std::size_t triangle) const;

  const TriangleMesh& mesh() const { return *mesh_; }
  const SurfaceRegions& regions() const { return regions_; }

 private:
  /// A triangle at an edge, whose vertices are in order.
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
  /// The cylinder, cone or torus whose circular edge this is; nothing where it is none.
  std::optional<SurfaceRegions::Label> rimOf(std::uint32_t a, std::uint32_t b) const;
  /// The direction of the axis; nothing where there is none.
  std::optional<Vector3> axisOf(const SurfaceRegions::Label& label) const;
  /// Of a round surface.
  MeasureFeature roundAt(const SurfaceRegions::Label& label, const Vector3& p) const;

  MeshPtr mesh_;
  SurfaceRegions regions_;
  std::vector<EdgeSide> sides_;  ///< in the order of their edges
};

/// A distance, with the two points that it is between.
struct MeasuredDistance {
  double metres = 0.0;
  Vector3 from = Vector3::Zero();
  Vector3 to = Vector3::Zero();
};

/// Vertices and edges as they are, faces as endless planes, cylinders, cones and tori as their axes, spheres as their
/// centres, points of free surfaces as points. Faces that are not parallel, and what crosses a plane, have the distance
/// 0. World frame or any other.
MeasuredDistance distanceBetween(const MeasureFeature& a, const MeasureFeature& b);

/// Radians from 0 to pi / 2: between edges and axes, between the planes of faces, between an edge and a face. Nothing
/// where one of the two has no direction.
std::optional<double> angleBetweenFeatures(const MeasureFeature& a, const MeasureFeature& b);

}  // namespace glissade
