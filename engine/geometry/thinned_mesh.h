#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "engine/geometry/continued_cones.h"
#include "engine/geometry/solid_interior.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/geometry/triangle_tree.h"

namespace glissade {

/// Largest share of the local thickness that thinning removes from one side.
inline constexpr double kMostThinning = 0.2;
/// Largest move of a corner, in allowances.
inline constexpr double kLongestThinning = 2.0;
/// Least distance of moving faces from open edges, in allowances: twice the depth within which the thickness below a
/// face is measured.
inline constexpr double kFarFromOpening = 10.0;

/// A body that can be thinned where its surface has an inside: everywhere if it is closed, else far enough from its
/// open edges.
///
/// Definition. The room of a face is its allowance, or a fifth of the thickness below the face if that is less. A
/// vertex moves to the intersection of the planes of its faces, each moved by its room: the least squares solution with
/// the faces' angles as weights. So it slides along faces without an allowance. Where that moves a face outwards, as at
/// a chamfer whose facets are tilted, or the vertex by more than two allowances, as where a face without an allowance
/// is nearly tangent to one that has one, the vertex moves against the mean of the normals of the faces with an
/// allowance, as far as these faces require. Where that also moves a face outwards, it moves by the largest allowance
/// of the faces against the mean of all normals, with the same weights. The move is shortened so that no face moves
/// farther than the largest allowance or its fifth, and the vertex by no more than two of these allowances. Where a
/// face still moves outwards, the vertex does not move. So the thinned body is inside the true one, to a hundred
/// thousandth of the allowance, and holds every point of it that is deeper than two allowances.
///
/// A chamfer moves with its cylinder: vertices of a cone that continues a cylinder with an allowance move perpendicular
/// to the axis onto the thinned cylinder where they are beyond it (continued_cones.h).
///
/// Open edges are those with one triangle, and those between triangles with inconsistent orientation. A face moves
/// where no open edge is nearer than kFarFromOpening of the largest allowance. Then a moved face is on the inner side
/// of the true surface if it does not cross that surface, the path between the two does not cross it, and most
/// directions from one point of each connected moved piece meet the surface from within: its winding number is three
/// quarters or more.
///
/// Immutable, shared by threads.
class ThinnableMesh {
 public:
  /// Prepares a mesh. Nothing where the mesh is empty or encloses nothing.
  static std::optional<ThinnableMesh> of(const TriangleMesh& mesh);

  /// The mesh thinned by an allowance (metres, > 0). Where a moved triangle would meet a true one, the moves of the
  /// corners that the two have in common, else of all, are reduced, in the end to zero, because a surface may cross
  /// itself. Nothing where that does not suffice.
  std::optional<TriangleMesh> thinned(double allowance) const;
  /// The mesh thinned by an allowance for each triangle of the original mesh, metres, >= 0. Faces without one do not
  /// move, except where they share a vertex with a face that has one. `share`: share of the thickness below a face that
  /// it may lose, instead of a fifth; below a half.
  std::optional<TriangleMesh> thinned(const std::vector<double>& allowances, double share = kMostThinning) const;

  /// Distance from the faces with an allowance to the nearest open edge, metres, if it is so small that the inside of
  /// the body there is not known; else nothing. Allowances as in thinned().
  std::optional<double> openBeside(const std::vector<double>& allowances) const;

  /// The largest thickness below a face, metres. An allowance above a fifth of it is reduced everywhere.
  double thickness() const { return thickness_; }

 private:
  struct Face {
    Vector3 normal;    ///< outward normal; zero where the face has almost no area
    double thickness;  ///< thickness below the face, metres
  };
  /// Required thinning of the faces.
  struct Wanted {
    std::vector<double> allowances;  ///< allowance of each face, metres
    double share;                    ///< share of the thickness below a face that it may lose
  };
  struct Corner {
    std::uint32_t face;
    double angle;
  };

  /// `sense`: 1 where triangles run counter-clockwise seen from outside, else -1.
  ThinnableMesh(TriangleMesh mesh, std::vector<std::uint32_t> sources, double sense);
  std::vector<double> ofFaces(const std::vector<double>& allowances) const;
  std::optional<double> openBesideFaces(const std::vector<double>& allowances) const;
  std::optional<TriangleMesh> thinnedFaces(const Wanted& wanted) const;
  double roomOf(std::size_t face, const Wanted& wanted) const { return wanted.share * faces_[face].thickness; }
  std::vector<Vector3> movesOf(const Wanted& wanted) const;
  Vector3 moveOf(std::size_t vertex, const Wanted& wanted) const;
  Vector3 againstThoseAllowed(std::size_t vertex, const Wanted& wanted, double largest) const;
  /// `largest`: largest allowance of the faces at the vertex.
  std::optional<Vector3> shortened(const Vector3& move, std::size_t vertex, const Wanted& wanted, double largest) const;
  std::vector<std::uint32_t> verticesOutside(const TriangleMesh& thinned,
                                             const std::vector<std::uint32_t>& among) const;
  std::vector<std::uint32_t> trianglesAt(const std::vector<std::uint32_t>& vertices) const;
  bool isInside(const TriangleMesh& thinned) const;
  bool isInsideLocally(const TriangleMesh& thinned) const;
  bool isBehind(std::size_t face, const TriangleMesh& thinned) const;

  TriangleMesh mesh_;
  std::vector<std::uint32_t> sources_;  ///< index of each triangle in the original mesh
  TriangleTree surface_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> openEdges_;
  std::optional<SolidInterior> interior_;  ///< nothing where there are open edges
  double sense_;                           ///< 1 where triangles run counter-clockwise seen from outside, else -1
  std::vector<Face> faces_;
  std::vector<std::vector<Corner>> corners_;  ///< corners of the faces at each vertex
  std::vector<ConeVertex> coneVertices_;
  std::vector<std::uint32_t> shells_;  ///< number of the connected surface of each triangle
  double thickness_ = 0.0;
};

}  // namespace glissade
