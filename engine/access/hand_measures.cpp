#include "engine/access/hand_measures.h"

#include <array>
#include <cstddef>
#include <numbers>

namespace glissade {
namespace {

constexpr std::array<HandMeasures, 3> kMeasures{{
    {0.165, 0.100, 0.072, 0.173, 0.142, 0.235, 0.404},
    {0.1865, 0.112, 0.083, 0.1995, 0.165, 0.2865, 0.459},
    {0.210, 0.127, 0.096, 0.230, 0.191, 0.348, 0.520},
}};

}  // namespace

double HandMeasures::handThickness() const {
  return (handCircumference - 2.0 * handBreadth) / (std::numbers::pi - 2.0);
}

const HandMeasures& measuresOf(HandSize size) { return kMeasures[static_cast<std::size_t>(size)]; }

}  // namespace glissade
