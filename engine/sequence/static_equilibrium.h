#pragma once

#include <vector>

#include "engine/geometry/pose.h"

namespace glissade {

/// A body that forces act on.
struct SupportedBody {
  double weight = 0.0;               ///< newtons, or any unit that is the same for all
  Vector3 centre = Vector3::Zero();  ///< of mass, world frame
  double size = 1.0;                 ///< metres: lever arm by which torques are compared with forces
  bool fixed = false;                ///< held by what is not modelled
};

/// A point at which one body supports another one.
struct SupportPoint {
  std::size_t a = 0;  ///< indices of the bodies
  std::size_t b = 0;
  Vector3 point = Vector3::Zero();
  Vector3 normal = Vector3::UnitZ();  ///< unit, out of `a`; of a bond without meaning
  bool bonded = false;                ///< takes every force and torque, as a thread or a press fit does
};

/// Which bodies are not in equilibrium under gravity (a unit direction): the forces at the points, within the pyramid
/// of the friction coefficient, that leave the least unbalanced forces in sum are found by a linear program (CLP).
/// Bonded bodies are one body. A body is out of equilibrium where more than a hundredth of its weight stays unbalanced.
/// One entry each.
std::vector<bool> outOfEquilibrium(const std::vector<SupportedBody>& bodies, const std::vector<SupportPoint>& points,
                                   const Vector3& gravity, double friction);

}  // namespace glissade
