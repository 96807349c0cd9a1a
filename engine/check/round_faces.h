#pragma once

#include <vector>

#include "engine/geometry/pose.h"

namespace glissade::check {

struct PlacedBody;

/// What the vertices of a cylinder are off it at most: metres, or a share of its radius where that is more.
inline constexpr double kOnCylinder = 1e-5;
inline constexpr double kShareOfCylinderRadius = 1e-3;
/// Sine of the angle between two axes that are taken for parallel.
inline constexpr double kParallelAxes = 1e-4;

/// A cylinder that vertices of a body lie on, world frame.
struct RoundFace {
  Vector3 point;  ///< on the axis
  Vector3 axis;   ///< unit
  double radius = 0.0;
  bool isShaft = true;  ///< the body is inside of it
  double low = 0.0;     ///< along the axis from the point, of its vertices
  double high = 0.0;
};

/// Those of a body: smooth surfaces that are round, and faces that its file calls cylinders.
std::vector<RoundFace> roundFacesOf(const PlacedBody& body);

}  // namespace glissade::check
