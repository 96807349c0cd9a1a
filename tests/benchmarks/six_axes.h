#pragma once

#include <vector>

#include "engine/base/stop_token.h"
#include "engine/sequence/body_group.h"

namespace glissade {

/// A body that left along one of the six axes.
struct SixAxesStep {
  std::size_t body = 0;
  Vector3 way = Vector3::Zero();  ///< from where it is assembled, metres
  BodySet others;                 ///< that were there
};

/// What others do, in short: body after body, straight along one of the six axes of the world until it is out of the
/// box of the others, looked at in 400 configurations. It may penetrate others by 0.15 mm: it is taken thinner by so
/// much. Nothing is proved of what is between. Ends where no body leaves, or after a stop.
std::vector<SixAxesStep> sixAxesSequence(const AssembledProduct& product, const BodySet& staying,
                                         const StopToken& stop);

/// By how much the body has to be taken thinner so that the kernel proves the whole motion free: the least of 0.15 mm
/// and a list of larger ones, metres; infinity where none of them does. It is about what the motion penetrates.
double penetrationOf(const AssembledProduct& product, const SixAxesStep& step, const StopToken& stop);

}  // namespace glissade
