#pragma once

#include "engine/geometry/pose.h"

namespace glissade {

/// A force and a torque on the object, about its reference point, world frame.
struct Wrench {
  Vector3 force_W = Vector3::Zero();
  Vector3 torque_W = Vector3::Zero();

  bool isZero() const { return force_W.isZero() && torque_W.isZero(); }
};

inline Wrench operator+(const Wrench& a, const Wrench& b) { return {a.force_W + b.force_W, a.torque_W + b.torque_W}; }
inline bool operator==(const Wrench& a, const Wrench& b) { return a.force_W == b.force_W && a.torque_W == b.torque_W; }
inline bool operator!=(const Wrench& a, const Wrench& b) { return !(a == b); }

}  // namespace glissade
