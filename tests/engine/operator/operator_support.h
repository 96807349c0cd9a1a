#pragma once

#include <limits>

#include "engine/operator/operator_input.h"

namespace glissade {

inline const Box3 kRoom(Vector3::Constant(-5.0), Vector3::Constant(5.0));

/// A view of a tree whose distance the function gives, with no obstacle near.
inline OperatorView viewOf(const Pose& q_device, std::function<double(const Pose&)> treeDistance) {
  return {q_device, OperatorFrame(), std::move(treeDistance), 0,
          [] { return std::numeric_limits<double>::infinity(); }};
}

/// A view in which the start tree is this far from everything.
inline OperatorView viewOf(const Pose& q_device, double treeDistance = 0.0) {
  return viewOf(q_device, [treeDistance](const Pose&) { return treeDistance; });
}

}  // namespace glissade
