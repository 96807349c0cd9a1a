#pragma once

#include <limits>

#include "engine/operator/operator_input.h"

namespace glissade {

inline const Box3 kRoom(Vector3::Constant(-5.0), Vector3::Constant(5.0));

/// A view in which the start tree is this far from everything.
inline OperatorView viewOf(const Pose& q_device, double treeDistance = 0.0) {
  return {q_device, OperatorFrame(), [treeDistance](const Pose&) { return treeDistance; }, Guidance()};
}

}  // namespace glissade
