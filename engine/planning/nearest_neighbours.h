#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/geometry/se3_metric.h"

namespace glissade {

/// Configurations with an index each, for trees that grow every step. Few are searched by a linear
/// scan over flat arrays, in which a lower bound without trigonometry settles nearly every node; many
/// lie in a grid over their positions besides, whose cells are searched ring by ring. Both find the
/// same.
class NearestNeighbours {
 public:
  struct Neighbour {
    std::uint32_t index = 0;
    double distance = 0.0;  ///< in the metric, metres
  };

  explicit NearestNeighbours(const Se3Metric& metric) : metric_(metric) {}

  void add(std::uint32_t index, const Pose& q);
  std::size_t size() const { return indices_.size(); }
  /// The nearest configuration in the metric, the one added first among equals; nothing when empty.
  std::optional<Neighbour> nearest(const Pose& q) const;

 private:
  /// The best so far: place in the arrays and squared distance.
  struct Best {
    std::size_t at;
    double squared;
    double distance;
  };
  using GridIndex = std::array<int, 3>;

  void consider(std::size_t at, const Pose& q, Best& best) const;
  void searchGrid(const Pose& q, Best& best) const;
  void buildGrid();
  GridIndex cellOf(double x, double y, double z) const;
  std::vector<std::uint32_t>& cell(const GridIndex& c) { return grid_[flat(c)]; }
  std::size_t flat(const GridIndex& c) const {
    return (static_cast<std::size_t>(c[0]) * static_cast<std::size_t>(counts_[1]) + static_cast<std::size_t>(c[1])) *
               static_cast<std::size_t>(counts_[2]) +
           static_cast<std::size_t>(c[2]);
  }

  Se3Metric metric_;
  std::vector<double> x_, y_, z_, qx_, qy_, qz_, qw_;
  std::vector<std::uint32_t> indices_;

  std::vector<std::vector<std::uint32_t>> grid_;  ///< places in the arrays; empty while there are few
  Vector3 least_ = Vector3::Zero();
  double edge_ = 1.0;
  GridIndex counts_{0, 0, 0};
  std::size_t nextBuild_ = 2048;
};

}  // namespace glissade
