#pragma once

#include <vector>

#include "engine/geometry/thread_standards.h"

namespace glissade::evidence {

/// A regular prism with a hole about its axis, metres.
struct NutShape {
  int sides = 0;       ///< 4 or 6; 0: it is no prism
  double width = 0.0;  ///< across the flats
  double height = 0.0;
  double hole = 0.0;  ///< radius
};

/// The sizes of threads that a nut of this shape may have. Empty if it is wider, narrower or flatter than nuts: a plate
/// with a hole.
std::vector<ThreadSize> nutSizes(const NutShape& nut);

/// The sizes that a shaft of this radius (metres) may be drawn for: by its diameter, or by its core if the diameter is
/// no nominal one.
std::vector<ThreadSize> shaftSizes(double radius);

/// The size that a name says by its diameter (metres; 0: none), else the sizes by shape.
std::vector<ThreadSize> sizesOf(double said, std::vector<ThreadSize> byShape);

/// True if the nut and the shaft have a size in common.
bool haveOneSize(const std::vector<ThreadSize>& nut, const std::vector<ThreadSize>& shaft);

}  // namespace glissade::evidence
