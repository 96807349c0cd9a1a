#pragma once

#include <optional>
#include <vector>

#include "engine/geometry/screw_axis.h"

namespace glissade {

/// A piece of a surface.
struct SurfacePatch {
  Vector3 point;
  Vector3 normal;  ///< unit, either sense
  double area = 0.0;
};

/// The screw motion that moves a surface along itself.
struct FittedScrew {
  ScrewAxis screw;
  double nearest = 0.0;   ///< least distance from the axis of patches that it moves along themselves
  double farthest = 0.0;  ///< largest such distance
};

/// True if the patch is moved along itself, within the sine of an angle.
bool isMovedAlongItself(const ScrewAxis& screw, const SurfacePatch& patch);

/// The screw motion that moves most of the patches along themselves, by robust least squares (Pottmann and Randrup,
/// "Rotational and helical surface approximation for reverse engineering", 1998). Nothing if it does not move half of
/// their area so, if these patches are not all around the axis, or if they could also be moved straight along it or
/// turned about it without advance: then it is no thread.
std::optional<FittedScrew> fitScrew(const std::vector<SurfacePatch>& patches);

}  // namespace glissade
