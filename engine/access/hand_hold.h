#pragma once

#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "engine/access/hand_posture.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// Excess of the hand's opening over the thickness that it pinches, metres.
inline constexpr double kPadGap = 0.001;

/// Largest distance of the middle of the pads behind a place that their tips touch, in breadths of the hand.
inline constexpr double kPadBack = 0.08;

/// A hand that holds a body or a tool at the beginning of a motion.
struct HandHold {
  MeshPtr hand;  ///< in the hand's frame
  Pose X_WH;
  MeshPtr tool = nullptr;  ///< tool in the hand; null: none
  Pose X_WT{};
  std::size_t firstBend = 0;  ///< index in wristBends() that is tried first
};

/// Meshes of one person's hand, each made once. Used by one thread.
class HandShapes {
 public:
  explicit HandShapes(HandSize size);

  struct Shape {
    MeshPtr mesh;
    Pose X_HG;
    double room = 0.0;  ///< see HandPosture::room
  };
  /// Nothing if the hand does not open that far. The opening is rounded up by at most two millimetres.
  const std::optional<Shape>& pinch(const Pinch& pinch);
  const Shape& fist(double diameter);
  const Shape& pointing();
  const MeshPtr& forearm() const { return forearm_; }
  const HandMeasures& measures() const { return measures_; }
  /// Largest opening of the hand, metres.
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
