#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/geometry/pose.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade::evidence {

/// A ring as a race of a rolling bearing.
struct BearingRing {
  Vector3 point = Vector3::Zero();  ///< on the axis
  Vector3 axis = Vector3::UnitZ();  ///< unit
  double hole = 0.0;                ///< radii, metres
  double outer = 0.0;
  double low = 0.0;  ///< range along the axis, from `point`
  double high = 0.0;

  double length() const { return high - low; }
  Vector3 middle() const { return point + 0.5 * (low + high) * axis; }
};

/// A ball or a roller of a bearing, by its middle.
struct RollingElement {
  Vector3 middle = Vector3::Zero();
  bool isBall = false;
};

/// The middle of a ball, in the frame of the mesh; nothing if the mesh is no ball.
std::optional<Vector3> ballMiddle(const TriangleMesh& mesh);

/// True if the rings are coaxial, beside each other, and `inner` is inside of `outer`.
bool areRaces(const BearingRing& inner, const BearingRing& outer);

/// True if the element is between the two races.
bool isBetween(const RollingElement& element, const BearingRing& inner, const BearingRing& outer);

/// True if a ring is a cage or a shield between the two races.
bool isCageOf(const BearingRing& ring, const BearingRing& inner, const BearingRing& outer);

/// True if a bearing may have so many rolling elements: three balls, or five rollers.
bool areOfBearing(std::size_t balls, std::size_t rollers);

}  // namespace glissade::evidence
