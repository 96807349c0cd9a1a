#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "engine/geometry/pose.h"

namespace glissade {

/// What distinguishes two corners at the same position.
struct CornerAttributes {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  Eigen::Vector2f texture = Eigen::Vector2f::Zero();
};

/// The reference point that OMPL.app gives to a robot: the mean of the corners of its triangles in single
/// precision. Corners at the same position count once where their attributes differ by less than 1e-5. Scenarios
/// refer to this point (`centre_on_vertex_mean`), so it stays what assimp and OMPL.app made of the file.
class CornerMean {
 public:
  void reserve(std::size_t corners) { corners_.reserve(corners); }
  /// `vertex` is the index of the position.
  void add(std::uint32_t vertex, const Vector3& position, const CornerAttributes& attributes);
  /// Corners from here on do not count as one with those before: another mesh of the file begins.
  void startSection() { ++section_; }
  /// Zero where there is no corner.
  Vector3 mean() const;

 private:
  struct Corner {
    CornerAttributes attributes;
    std::uint32_t section;
    std::uint32_t previous;  ///< at the same position
  };

  bool isKnown(std::uint32_t vertex, const CornerAttributes& attributes) const;

  std::vector<std::uint32_t> newest_;  ///< by vertex
  std::vector<Corner> corners_;
  std::uint32_t section_ = 0;
  Eigen::Vector3f sum_ = Eigen::Vector3f::Zero();
};

}  // namespace glissade
