#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "engine/geometry/pose.h"

namespace glissade {

/// Attributes that distinguish two corners at the same position.
struct CornerAttributes {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  Eigen::Vector2f texture = Eigen::Vector2f::Zero();
};

/// Computes the reference point that OMPL.app gives to a robot: the mean of the corners of its triangles in single
/// precision. Corners at the same position count once if their attributes differ by less than 1e-5. Scenarios refer to
/// this point (`centre_on_vertex_mean`), so it has to equal the result of assimp and OMPL.app.
class CornerMean {
 public:
  void reserve(std::size_t corners) { corners_.reserve(corners); }
  /// `vertex`: index of the position.
  void add(std::uint32_t vertex, const Vector3& position, const CornerAttributes& attributes);
  /// Begins another mesh of the file: later corners do not merge with earlier ones.
  void startSection() { ++section_; }
  /// Zero if there is no corner.
  Vector3 mean() const;

 private:
  struct Corner {
    CornerAttributes attributes;
    std::uint32_t section;
    std::uint32_t previous;  ///< previous corner at the same position
  };

  bool isKnown(std::uint32_t vertex, const CornerAttributes& attributes) const;

  std::vector<std::uint32_t> newest_;  ///< newest corner of each vertex
  std::vector<Corner> corners_;
  std::uint32_t section_ = 0;
  Eigen::Vector3f sum_ = Eigen::Vector3f::Zero();
};

}  // namespace glissade
