#pragma once

#include <vector>

#include "engine/base/message.h"
#include "engine/base/stop_token.h"
#include "engine/files/scenario.h"
#include "engine/planning/path.h"

namespace glissade {

/// Says which threads a path pulls the object off instead of turning it out, one sentence for each other body; empty:
/// none. The threads are those that the judge sees (evidence::commonThreads()); a person's word about the fit of a pair
/// is heeded. A path of one object may do that, because its world takes it thinner there.
std::vector<Message> pulledThreadsOf(const LoadedScenario& scenario, const std::vector<PathPoint>& path,
                                     const StopToken& stop = {});

}  // namespace glissade
