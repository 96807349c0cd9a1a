#pragma once

#include <vector>

#include "engine/geometry/plane_section.h"

namespace glissade {

/// A plane that cuts a view open. A person moves it along its direction.
struct SectionPlane {
  Vector3 direction = Vector3::UnitX();  ///< unit vector
  double place = 0.0;                    ///< position along the direction from the origin of the world, metres
  bool otherSide = false;  ///< cuts away the side opposite to the direction, instead of the side in its direction
  bool on = true;
};

/// The plane whose normal points to the side that is cut away.
Plane planeOf(const SectionPlane& section);

/// Range of the positions at which the plane meets a box, which is not empty.
struct PlaceRange {
  double least = 0.0;
  double greatest = 0.0;
};
PlaceRange rangeAlong(const Vector3& direction, const Box3& box);

/// The corners of the polygon in which a plane cuts a box, in order; fewer than three where it does not.
std::vector<Vector3> outlineInBox(const Plane& plane, const Box3& box);

}  // namespace glissade
