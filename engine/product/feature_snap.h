#pragma once

#include <cstdint>
#include <vector>

#include "engine/product/snap_features.h"

namespace glissade {

/// A shift that puts features of a body onto features of other bodies.
struct FeatureSnap {
  struct Pair {
    std::size_t moving;  ///< index of the body's feature
    std::size_t fixed;   ///< index of the other body's feature
  };
  Vector3 shift = Vector3::Zero();  ///< metres, world
  std::vector<Pair> pairs;          ///< that meet, the nearest first; empty: nothing is near enough
};

/// Lets a body that is moved without turning snap to planes and axes of other bodies: its faces come to lie in parallel
/// planes, its axes on parallel axes. Pairs that are parallel are found once; a shift then takes one pass over them.
class FeatureSnapper {
 public:
  /// The features of the body where the shift is zero, and those of the others; in the world. `size`: metres of the
  /// body. Features snap where they are not farther apart than that along the face, or along the axis.
  FeatureSnapper(std::vector<SnapFeature> moving, std::vector<SnapFeature> fixed, double size);

  /// The nearest shift that differs from `shift` by at most `reach` metres in the directions of `freedom` (orthonormal,
  /// one to three) and lets pairs meet; with what freedom is left, further pairs. `shift` where there is none.
  FeatureSnap snap(const Vector3& shift, const std::vector<Vector3>& freedom, double reach) const;

  const std::vector<SnapFeature>& moving() const { return moving_; }
  const std::vector<SnapFeature>& fixed() const { return fixed_; }

 private:
  struct Pair {
    std::uint32_t moving;
    std::uint32_t fixed;
  };
  struct Step {
    FeatureSnap::Pair pair;
    Vector3 by;
  };

  /// What is between the pair after this shift: across the plane, or across the axis.
  Vector3 gapOf(const Pair& pair, const Vector3& shift) const;
  bool areNear(const Pair& pair, const Vector3& shift) const;
  /// The least movement in the directions that lets one pair meet; false: none does within the reach.
  bool findStep(const Vector3& shift, const std::vector<Vector3>& freedom, double reach, Step& step) const;

  std::vector<SnapFeature> moving_;
  std::vector<SnapFeature> fixed_;
  double size_;
  std::vector<Pair> pairs_;
};

}  // namespace glissade
