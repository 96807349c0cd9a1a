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

/// From either side a thinned body loses at most this share of its local thickness.
inline constexpr double kMostThinning = 0.2;
/// A corner moves by at most this many allowances.
inline constexpr double kLongestThinning = 2.0;
/// Where a surface is open, its edges are farther from faces that move than this many allowances: twice as far as a
/// face looks below itself for its thickness.
inline constexpr double kFarFromOpening = 10.0;

/// A body that can be taken thinner where its surface has an inside: everywhere where it is closed, else far enough
/// from its open edges.
///
/// Definition. A face may move inwards by its room: its allowance, or a fifth of the thickness below the face where
/// that is less. A vertex moves to where the planes of its faces, each moved by its room, meet: the least squares'
/// solution with the faces' angles as weights. So it slides along faces without an allowance. Where that moves a face
/// outwards, as at a chamfer whose facets are tilted, it moves against the mean of the normals of the faces that have
/// an allowance, as far as these ask for; where that moves one outwards, too, by the largest allowance of the faces
/// against the mean of all normals, with the same weights. The move is shortened so that no face moves farther than the
/// largest allowance or its fifth, and the vertex by no more than two of these allowances; where a face moves outwards
/// still, the vertex stays. So the thinned body is inside the true one, to a hundred thousandth of the allowance, and
/// holds every point of it that is deeper than two allowances.
///
/// A chamfer goes where its cylinder goes: vertices of a cone that continues a cylinder with an allowance move across
/// the axis onto the thinned cylinder where they are beyond it (continued_cones.h).
///
/// Open edges are those with one triangle, and those between triangles that do not agree on an outside. A face moves
/// where no such edge is nearer than kFarFromOpening of the largest allowance. Then a moved face is on the inner side
/// of the true surface where it crosses none of it, the way between the two crosses none, and most of all directions
/// from one point of each connected piece that has moved meet the surface from within: its winding number is three
/// quarters or more.
///
/// Immutable, shared by threads.
class ThinnableMesh {
 public:
  /// Nothing where the mesh is empty or encloses nothing.
  static std::optional<ThinnableMesh> of(const TriangleMesh& mesh);

  /// The mesh thinned by an allowance (metres, > 0). Where a moved triangle would meet a true one, the corners that
  /// it has in common with that one, else all, move less, and stay in the end, because a surface may cross itself.
  /// Nothing where that does not help.
  std::optional<TriangleMesh> thinned(double allowance) const;
  /// Each triangle of the mesh that this was made of has an allowance of its own, metres, >= 0. Faces without one stay
  /// whole, except where they share a vertex with one that has.
  /// `share`: what a face may lose of the thickness below it, instead of a fifth; below a half.
  std::optional<TriangleMesh> thinned(const std::vector<double>& allowances, double share = kMostThinning) const;

  /// Metres from the faces that have an allowance to the nearest open edge, where it is so near that what is inside the
  /// body there is not known; nothing where it is farther. Allowances as of thinned().
  std::optional<double> openBeside(const std::vector<double>& allowances) const;

  /// The largest thickness below a face, metres: an allowance above a fifth of it is nowhere taken in full.
  double thickness() const { return thickness_; }

 private:
  struct Face {
    Vector3 normal;    ///< outwards; zero where the face has next to no area
    double thickness;  ///< below it, metres
  };
  /// What is asked of the faces.
  struct Wanted {
    std::vector<double> allowances;  ///< metres, of each face
    double share;                    ///< of the thickness below a face that it may lose
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
  /// `largest`: of the allowances of the faces at the vertex.
  std::optional<Vector3> shortened(const Vector3& move, std::size_t vertex, const Wanted& wanted, double largest) const;
  std::vector<std::uint32_t> verticesOutside(const TriangleMesh& thinned,
                                             const std::vector<std::uint32_t>& among) const;
  std::vector<std::uint32_t> trianglesAt(const std::vector<std::uint32_t>& vertices) const;
  bool isInside(const TriangleMesh& thinned) const;
  bool isInsideLocally(const TriangleMesh& thinned) const;
  bool isBehind(std::size_t face, const TriangleMesh& thinned) const;

  TriangleMesh mesh_;
  std::vector<std::uint32_t> sources_;  ///< number of each triangle in the mesh that this was made of
  TriangleTree surface_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> openEdges_;
  std::optional<SolidInterior> interior_;  ///< nothing where there are open edges
  double sense_;                           ///< 1 where triangles run counter-clockwise seen from outside, else -1
  std::vector<Face> faces_;
  std::vector<std::vector<Corner>> corners_;  ///< at each vertex
  std::vector<ConeVertex> coneVertices_;
  std::vector<std::uint32_t> shells_;  ///< number of the connected surface, of each triangle
  double thickness_ = 0.0;
};

}  // namespace glissade
