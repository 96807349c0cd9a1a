#pragma once

#include <optional>

#include "engine/fits/joint.h"

namespace glissade {

/// A standard size of a hex key, socket or wrench.
struct KeySize {
  double size = 0.0;        ///< metres, across the flats
  const char* inches = "";  ///< text of an inch size: "3/16"; empty: a metric size
};

/// The key that turns a hexagon of this width across the flats (metres): the largest that fits into a recess, the
/// smallest that fits over a head. Metric sizes (ISO 2936 and ISO 272) come first. Nothing if no size fits closely
/// enough to turn it, and for drives that are no hexagon.
std::optional<KeySize> keyFor(DriveKind drive, double across);

}  // namespace glissade
