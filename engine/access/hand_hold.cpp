#include "engine/access/hand_hold.h"

#include <cmath>

#include "engine/access/hand_shape.h"

namespace glissade {
namespace {

constexpr double kStep = 0.002;  ///< metres between two openings

int stepsOf(double length) { return static_cast<int>(std::ceil(length / kStep)); }

MeshPtr meshOf(const HandMeasures& hand, const HandPosture& posture) {
  return std::make_shared<const TriangleMesh>(handShape(hand, posture));
}

}  // namespace

HandShapes::HandShapes(HandSize size)
    : measures_(measuresOf(size)), forearm_(std::make_shared<const TriangleMesh>(forearmShape(measures_))) {
  for (const double tilt : kPinchTilts) {
    for (double opening = kStep; pinchPosture(measures_, {opening, 2, tilt}); opening += kStep) {
      largestOpening_ = std::max(largestOpening_, opening);
    }
  }
}

const std::optional<HandShapes::Shape>& HandShapes::pinch(const Pinch& pinch) {
  const int steps = stepsOf(pinch.opening);
  const auto [at, isNew] = pinches_.try_emplace({steps, pinch.fingers, pinch.tilt});
  if (isNew) {
    const auto posture = pinchPosture(measures_, {kStep * steps, pinch.fingers, pinch.tilt});
    if (posture) at->second = Shape{meshOf(measures_, *posture), posture->X_HG, posture->room};
  }
  return at->second;
}

const HandShapes::Shape& HandShapes::fist(double diameter) {
  const int steps = stepsOf(diameter);
  const auto [at, isNew] = fists_.try_emplace(steps);
  if (isNew) {
    const HandPosture posture = fistPosture(measures_, kStep * steps);
    at->second = {meshOf(measures_, posture), posture.X_HG, posture.room};
  }
  return at->second;
}

const HandShapes::Shape& HandShapes::pointing() {
  if (!pointing_) {
    const HandPosture posture = pointingPosture(measures_);
    pointing_ = {meshOf(measures_, posture), posture.X_HG, posture.room};
  }
  return *pointing_;
}

}  // namespace glissade
