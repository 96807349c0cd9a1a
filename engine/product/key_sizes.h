#pragma once

#include <optional>

#include "engine/product/joint.h"

namespace glissade {

/// A hex key, socket or wrench as one buys it.
struct KeySize {
  double size = 0.0;        ///< metres, across the flats
  const char* inches = "";  ///< of an inch size: "3/16"; empty: a metric size
};

/// The key that turns a hexagon of this width across the flats (metres): the largest that goes into a recess, the
/// smallest that goes over a head. Metric sizes (ISO 2936 and ISO 272) come first. Nothing where no size fits closely
/// enough to turn it, and for drives that are no hexagon.
std::optional<KeySize> keyFor(DriveKind drive, double across);

}  // namespace glissade
