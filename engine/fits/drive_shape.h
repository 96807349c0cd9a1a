#pragma once

#include <optional>

#include "engine/fits/axial_slabs.h"
#include "engine/fits/joint.h"

namespace glissade {

struct DriveShape {
  DriveKind kind = DriveKind::None;
  double size = 0.0;  ///< see Joint::driveSize, metres
};

/// The width across the flats of a regular prism with this number of sides, from the distances of its surface in each
/// direction; nothing if it is no such prism. Corners may be cut or round.
std::optional<double> acrossFlats(const std::vector<double>& radii, int sides);

/// The drive of a recess with its surface at these distances from the axis. `head`: radius of the screw's head, metres.
DriveShape recessShape(const std::vector<double>& radii, double head);

}  // namespace glissade
