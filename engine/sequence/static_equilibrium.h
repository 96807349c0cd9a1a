#pragma once

#include <vector>

#include "engine/geometry/pose.h"

namespace glissade {

/// A body on which forces act.
struct SupportedBody {
  double weight = 0.0;               ///< newtons, or any unit that is the same for all
  Vector3 centre = Vector3::Zero();  ///< centre of mass, world frame
  double size = 1.0;                 ///< metres: the lever arm that converts torques to forces
  bool fixed = false;                ///< held by something that is not modelled
};

/// A point at which one body supports another one.
struct SupportPoint {
  std::size_t a = 0;  ///< indices of the bodies
  std::size_t b = 0;
  Vector3 point = Vector3::Zero();
  Vector3 normal = Vector3::UnitZ();  ///< unit, out of `a`; ignored for a bond
  bool bonded = false;                ///< transmits every force and torque, as a thread or a press fit does
};

/// Finds the bodies that are not in equilibrium under gravity (a unit direction). A linear program (CLP) finds the
/// forces at the points, within the pyramid of the friction coefficient, with the least sum of unbalanced forces.
/// Bonded bodies are one body. A body is out of equilibrium if more than a hundredth of its weight stays unbalanced.
/// Returns one entry for each body.
std::vector<bool> outOfEquilibrium(const std::vector<SupportedBody>& bodies, const std::vector<SupportPoint>& points,
                                   const Vector3& gravity, double friction);

}  // namespace glissade
