#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "engine/geometry/se3_metric.h"

namespace glissade {

/// Configurations with an index each, for trees that grow every step. They lie in a k-d tree over orientation and
/// position (Bentley 1975, with tight boxes as in a hierarchy of bounding volumes). The angle between two orientations
/// follows from the chord between their quaternions, so that the distance of (2 r quaternion, p) to a box bounds the
/// metric from below. Bounds are computed in single precision with a margin for its rounding, several numbers at once;
/// the metric itself decides among the remaining candidates. Quaternions are stored with one sign. A query searches
/// with both signs; the search with the opposite sign ends at once, except near half turns.
class NearestNeighbours {
 public:
  struct Neighbour {
    std::uint32_t index = 0;
    double distance = 0.0;  ///< distance in the metric, metres
  };

  explicit NearestNeighbours(const Se3Metric& metric) : metric_(metric) {}

  void add(std::uint32_t index, const Pose& q);
  std::size_t size() const { return indices_.size(); }
  /// The nearest configuration in the metric, the one added first among equals; nothing when empty.
  std::optional<Neighbour> nearest(const Pose& q) const;

 private:
  static constexpr std::size_t kAxes = 7;
  static constexpr std::size_t kOrientationAxes = 4;
  static constexpr std::size_t kLanes = 8;
  /// Orientation first, then position; the eighth number is zero.
  using Point = std::array<float, kAxes + 1>;

  static constexpr Point everywhere(float value) { return {value, value, value, value, value, value, value, 0.0F}; }

  /// Up to eight configurations, axis by axis; unused lanes lie infinitely far away.
  struct Packet {
    std::array<std::array<float, kLanes>, kAxes> at;
    std::array<std::uint32_t, kLanes> entry;
  };
  struct Node {
    Point low = everywhere(std::numeric_limits<float>::infinity());
    Point high = everywhere(-std::numeric_limits<float>::infinity());
    std::uint32_t children = 0;  ///< index of the first of two children; 0: a leaf
    std::size_t axis = 0;
    float split = 0.0F;  ///< value between the children on the axis, below which the first child lies
    std::vector<Packet> packets;
    std::size_t count = 0;  ///< number of configurations of a leaf
  };
  struct Search;

  Point pointOf(const Pose& q) const;
  static void addToLeaf(Node& leaf, std::uint32_t entry, const Point& point);
  void splitLeaf(std::uint32_t node);
  void visit(std::uint32_t node, Search& search) const;
  void look(const Packet& packet, Search& search) const;

  Se3Metric metric_;
  std::vector<Pose> poses_;
  std::vector<std::uint32_t> indices_;
  std::vector<Node> nodes_;
  Vector3 origin_ = Vector3::Zero();  ///< origin of the positions in the tree: the first position
  double scale_ = 0.0;                ///< largest coordinate in the tree
};

}  // namespace glissade
