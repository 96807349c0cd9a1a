#pragma once

#include <optional>
#include <string>

#include "engine/check/placed_bodies.h"

namespace glissade::check {

/// The diameter of the thread (metres) that the name of a screw states: "DIN 912 M4x10", "ST4.2x35", "1/4-20 x 1",
/// "wood screw 4x30". Nothing where it names no screw, or no size.
std::optional<double> screwSizeIn(const std::string& name);

/// The shaft of a screw where it is in a body that is drawn without a hole for it, world frame.
struct ScrewInSolid {
  Vector3 point = Vector3::Zero();  ///< on the axis
  Vector3 axis = Vector3::UnitZ();  ///< unit
  double radius = 0.0;
  double low = 0.0;  ///< of the part that is in the body, along the axis from the point, metres
  double high = 0.0;
};

/// A screw makes its hole where its name states its size, a cylinder of it has that size, nothing but this cylinder and
/// what is before it is in the host, and the host has no hole about its axis. Nothing where one of these does not hold.
std::optional<ScrewInSolid> screwInSolid(const Placement& screw, const Placement& host, PlacedBodies& bodies,
                                         const StopToken& stop);

}  // namespace glissade::check
