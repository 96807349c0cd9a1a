#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/pose.h"

namespace glissade::evidence {

struct PlacedBody;

/// Distance of vertices from a small cylinder that they lie on, and of two coaxial axes, metres.
inline constexpr double kOnCylinder = 1e-5;
/// Sine of the largest angle between two parallel axes.
inline constexpr double kParallelAxes = 1e-4;

/// Largest distance of a vertex from the cylinder of this radius that it lies on, metres: kOnCylinder, or a share of
/// the radius if that is more.
double vertexTolerance(double radius);

/// A cylinder that vertices of a body lie on, world frame.
struct RoundFace {
  Vector3 point;  ///< on the axis
  Vector3 axis;   ///< unit
  double radius = 0.0;
  bool isShaft = true;  ///< the body is inside of the cylinder
  double low = 0.0;     ///< range of its vertices along the axis, from `point`
  double high = 0.0;
};

/// The cylinders of a body: smooth surfaces that are round, and faces that its file calls cylinders. None is a part of
/// an earlier one.
std::vector<RoundFace> roundFacesOf(const PlacedBody& body);

/// Whether the triangle of the body lies on the round face.
bool isOf(const RoundFace& round, const PlacedBody& body, std::uint32_t triangle);

}  // namespace glissade::evidence
