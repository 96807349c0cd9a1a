#pragma once

#include <optional>
#include <string>

#include "engine/evidence/placed_bodies.h"

namespace glissade::evidence {

/// Diameter of the thread (metres) in the name of a screw: "DIN 912 M4x10", "ST4.2x35", "1/4-20 x 1", "wood screw
/// 4x30". Nothing if the name is of no screw, or has no size.
std::optional<double> screwSizeIn(const std::string& name);

/// The shaft of a screw inside a body that is drawn without a tapped hole for it, world frame.
struct ScrewInSolid {
  Vector3 point = Vector3::Zero();  ///< on the axis
  Vector3 axis = Vector3::UnitZ();  ///< unit
  double radius = 0.0;
  double low = 0.0;  ///< range of the part in the body, along the axis from `point`, metres
  double high = 0.0;
};

/// A screw makes its hole in a solid body if its name states its size and one of its cylinders has that size. It forms
/// its thread in the ribs of a slot, which is as wide as the screw or wider between them, if its name states the size
/// or ends with a word for a screw, and the ribs are no deeper in the cylinder than a thread. Only this cylinder and
/// the part before it are in the host, no gap in the host about the axis is half a turn, and the host has no other hole
/// there. Nothing if one of these conditions fails.
std::optional<ScrewInSolid> screwInSolid(const Placement& screw, const Placement& host, PlacedBodies& bodies,
                                         const StopToken& stop);

}  // namespace glissade::evidence
