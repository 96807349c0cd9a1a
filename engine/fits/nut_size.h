#pragma once

#include <string>
#include <vector>

#include "engine/fits/fastener_shape.h"
#include "engine/geometry/thread_standards.h"

namespace glissade {

/// The sizes of threads that a nut of this shape may have, by its width across the flats, its height and its hole.
/// Empty if it is wider, narrower or flatter than nuts: a plate with a hole.
std::vector<ThreadSize> nutSizes(const TurnedShape& nut);

/// The sizes that a shaft of this radius (metres) may be drawn for: by its diameter, or by its core if the diameter is
/// no nominal one.
std::vector<ThreadSize> shaftSizes(double radius);

/// True if the nut and the shaft have a size in common.
bool haveOneSize(const std::vector<ThreadSize>& nut, const std::vector<ThreadSize>& shaft);

}  // namespace glissade
