#pragma once

#include <cstdint>
#include <vector>

#include "engine/fits/snap_features.h"

namespace glissade {

/// A shift that moves features of a body onto features of other bodies.
struct FeatureSnap {
  struct Pair {
    std::size_t moving;  ///< index of the body's feature
    std::size_t fixed;   ///< index of the other body's feature
  };
  Vector3 shift = Vector3::Zero();  ///< metres, world
  std::vector<Pair> pairs;          ///< pairs that meet, the nearest first; empty: none is near enough
};

/// Lets a body that moves without turning snap to planes and axes of other bodies: its faces move into parallel planes,
/// its axes onto parallel axes. Parallel pairs are found once; a shift then takes one pass over them.
class FeatureSnapper {
 public:
  /// The features of the body at zero shift, and those of other bodies, in the world frame. `size`: size of the body,
  /// metres. Features snap if they are no farther apart than `size` along the face, or along the axis.
  FeatureSnapper(std::vector<SnapFeature> moving, std::vector<SnapFeature> fixed, double size);

  /// The nearest shift that differs from `shift` by at most `reach` metres in the directions of `freedom` (orthonormal,
  /// one to three) and lets pairs meet. Further pairs meet with the freedom that is left. Returns `shift` if there is
  /// none.
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

  /// The gap of the pair after this shift: across the plane, or across the axis.
  Vector3 gapOf(const Pair& pair, const Vector3& shift) const;
  bool areNear(const Pair& pair, const Vector3& shift) const;
  /// Finds the smallest movement in the directions that lets one pair meet; false if none does within the reach.
  bool findStep(const Vector3& shift, const std::vector<Vector3>& freedom, double reach, Step& step) const;

  std::vector<SnapFeature> moving_;
  std::vector<SnapFeature> fixed_;
  double size_;
  std::vector<Pair> pairs_;
};

}  // namespace glissade
