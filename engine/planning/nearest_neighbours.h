#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/geometry/se3_metric.h"

namespace glissade {

/// Configurations with an index each, searched by a linear scan over flat arrays: below some 30,000
/// nodes it beats trees, because a lower bound without trigonometry settles nearly every node.
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
  Se3Metric metric_;
  std::vector<double> x_, y_, z_, qx_, qy_, qz_, qw_;
  std::vector<std::uint32_t> indices_;
};

}  // namespace glissade
