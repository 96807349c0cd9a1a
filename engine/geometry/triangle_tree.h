#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "engine/geometry/nearest_point.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/geometry/triangle_pair.h"

namespace glissade {

/// Triangles in a hierarchy of boxes, for nearest points, for rays and for pairs that are near. Triangles keep their
/// indices. Immutable, shared by threads.
class TriangleTree {
 public:
  explicit TriangleTree(std::vector<Triangle> triangles);
  explicit TriangleTree(const TriangleMesh& mesh);

  const std::vector<Triangle>& triangles() const { return triangles_; }
  const Box3& box() const { return box_; }

  struct Nearest {
    double distance = 0.0;
    std::uint32_t triangle = 0;  ///< undefined where no triangle is nearer than the limit
  };
  /// The triangle nearest to `p`; distance `limit` where none is nearer. With `enough`, any triangle that is at most
  /// `enough` away may be returned.
  Nearest nearest(const Vector3& p, double limit, double enough = 0.0) const;

  /// Distance of the segment from a to b; `limit` where it is not less. With `enough`, the distance of any triangle
  /// that is at most `enough` away may be returned.
  double distanceToSegment(const Vector3& a, const Vector3& b, double limit, double enough = 0.0) const;

  /// The least t > `after` at which origin + t * direction lies on a triangle, including its border within rounding;
  /// infinity where there is none.
  double firstHit(const Vector3& origin, const Vector3& direction, double after) const;

  /// Calls `take` for every triangle whose box meets the given one, until it returns false.
  void visit(const Box3& box, const std::function<bool(std::uint32_t)>& take) const;

  /// Calls `take` for every pair (a triangle of this tree, one of the other) whose boxes are at most `distance` apart
  /// along each axis, until it returns false.
  void visitPairs(const TriangleTree& other, double distance,
                  const std::function<bool(std::uint32_t, std::uint32_t)>& take) const;

  /// Calls `take` for every such pair, in any order. Among many triangles several threads call `take` at the same time.
  void visitAllPairs(const TriangleTree& other, double distance,
                     const std::function<void(std::uint32_t, std::uint32_t)>& take) const;

 private:
  using NodePair = std::pair<std::uint32_t, std::uint32_t>;  ///< a node of this tree and one of the other
  struct Node {
    Box3 box;
    std::uint32_t first = 0;  ///< index in `order_` for a leaf, else index of the child that is not the next node
    std::uint32_t count = 0;  ///< number of a leaf's triangles; 0: no leaf
    double size = 0.0;        ///< diagonal of the box
  };

  void build(std::uint32_t first, std::uint32_t last);
  template <class Take>
  bool visitPair(const TriangleTree& other, double distance, const NodePair& pair, std::vector<NodePair>& open,
                 const Take& take) const;
  template <class ToBox, class ToTriangle>
  Nearest nearestBy(const ToBox& toBox, const ToTriangle& toTriangle, double limit, double enough) const;
  template <class Enters, class Take>
  void walk(const Enters& enters, const Take& take) const;

  std::vector<Triangle> triangles_;
  std::vector<Box3> boxes_;  ///< bounding box of each triangle
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
  Box3 box_;
};

}  // namespace glissade
