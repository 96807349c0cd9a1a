#pragma once

#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "engine/access/hand_posture.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// Metres that a hand is open more than what it pinches is thick.
inline constexpr double kPadGap = 0.001;

/// Of the hand's breadth: so far behind a place the middle of the pads may be, which then touch it with their tips.
inline constexpr double kPadBack = 0.08;

/// A hand that holds something where its motion begins, and the tool in it.
struct HandHold {
  MeshPtr hand;  ///< in the hand's frame
  Pose X_WH;
  MeshPtr tool = nullptr;  ///< null: none
  Pose X_WT{};
  std::size_t firstBend = 0;  ///< of wristBends(): tried first
};

/// Meshes of one person's hand, each made once. Not for several threads.
class HandShapes {
 public:
  explicit HandShapes(HandSize size);

  struct Shape {
    MeshPtr mesh;
    Pose X_HG;
    double room = 0.0;  ///< as HandPosture::room
  };
  /// Nothing where the hand does not open so far. The opening is rounded up by at most two millimetres.
  const std::optional<Shape>& pinch(const Pinch& pinch);
  const Shape& fist(double diameter);
  const Shape& pointing();
  const MeshPtr& forearm() const { return forearm_; }
  const HandMeasures& measures() const { return measures_; }
  /// Metres that the hand opens at most.
  double largestOpening() const { return largestOpening_; }

 private:
  HandMeasures measures_;
  MeshPtr forearm_;
  double largestOpening_ = 0.0;
  std::map<std::tuple<int, int, double>, std::optional<Shape>> pinches_;
  std::map<int, Shape> fists_;
  std::optional<Shape> pointing_;
};

}  // namespace glissade
