#pragma once

#include <optional>
#include <vector>

#include "engine/geometry/screw_axis.h"

namespace glissade {

/// A piece of a surface.
struct SurfacePatch {
  Vector3 point;
  Vector3 normal;  ///< unit, of either sense
  double area = 0.0;
};

/// The screw motion that moves a surface along itself.
struct FittedScrew {
  ScrewAxis screw;
  double nearest = 0.0;   ///< least distance from the axis of the patches that it moves along themselves
  double farthest = 0.0;  ///< largest
};

/// A patch is moved along itself, within the sine of an angle.
bool isMovedAlongItself(const ScrewAxis& screw, const SurfacePatch& patch);

/// The screw motion that moves most of the patches along themselves, in the sense of robust least squares (Pottmann
/// and Randrup, "Rotational and helical surface approximation for reverse engineering", 1998). Nothing where half of
/// their area is not moved so, where these do not lie all around the axis, where they could be moved straight along it,
/// or where they could be turned about it without the advance: then it is no thread.
std::optional<FittedScrew> fitScrew(const std::vector<SurfacePatch>& patches);

}  // namespace glissade
