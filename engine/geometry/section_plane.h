#pragma once

#include <vector>

#include "engine/geometry/plane_section.h"

namespace glissade {

/// A plane that a view is cut open by, as a person moves it: along its direction.
struct SectionPlane {
  Vector3 direction = Vector3::UnitX();  ///< unit
  double place = 0.0;                    ///< metres along the direction, from the origin of the world
  bool otherSide = false;                ///< what lies against the direction is cut away, instead of what lies along it
  bool on = true;
};

/// What lies on the side of its normal is cut away.
Plane planeOf(const SectionPlane& section);

/// The least and the greatest place that meet a box, which is not empty.
struct PlaceRange {
  double least = 0.0;
  double greatest = 0.0;
};
PlaceRange rangeAlong(const Vector3& direction, const Box3& box);

/// The corners of the polygon in which a plane cuts a box, in their order; fewer than three where it does not.
std::vector<Vector3> outlineInBox(const Plane& plane, const Box3& box);

}  // namespace glissade
