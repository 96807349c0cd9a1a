#pragma once

#include <vector>

#include "engine/geometry/pose.h"

namespace glissade::check {

struct PlacedBody;

/// Largest distance of vertices from their cylinder: metres, or a share of its radius if that is more.
inline constexpr double kOnCylinder = 1e-5;
inline constexpr double kShareOfCylinderRadius = 1e-3;
/// Sine of the largest angle between two parallel axes.
inline constexpr double kParallelAxes = 1e-4;

/// A cylinder that vertices of a body lie on, world frame.
struct RoundFace {
  Vector3 point;  ///< on the axis
  Vector3 axis;   ///< unit
  double radius = 0.0;
  bool isShaft = true;  ///< the body is inside of the cylinder
  double low = 0.0;     ///< range of its vertices along the axis, from `point`
  double high = 0.0;
};

/// The cylinders of a body: smooth surfaces that are round, and faces that its file calls cylinders.
std::vector<RoundFace> roundFacesOf(const PlacedBody& body);

}  // namespace glissade::check
