#pragma once

#include <algorithm>

#include "engine/places/rigid_body.h"

namespace glissade {

/// Colours of places as in paper 2, figure 6: from green (easy) over orange to red (hard), and yellow if mobile bodies
/// clutter the place. Okabe and Ito's hues do not rely on red against green.
inline Colour complexityColour(int complexity, bool cluttered) {
  if (cluttered) return {0.94, 0.89, 0.26};
  constexpr std::array<Colour, 5> kScale{
      {{0.00, 0.62, 0.45}, {0.34, 0.71, 0.91}, {0.90, 0.62, 0.00}, {0.84, 0.37, 0.00}, {0.72, 0.11, 0.11}}};
  return kScale[static_cast<std::size_t>(std::clamp(complexity, 1, 5) - 1)];
}

}  // namespace glissade
