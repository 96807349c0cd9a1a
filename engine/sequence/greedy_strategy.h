#pragma once

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// Waves: all bodies are asked whether they can leave by straight motions; those that can do so, the smallest first.
/// Where none can, some are asked with more effort. A body that was refused is asked again with the same effort only
/// when one of the bodies in its way has left. How many are asked at the same time does not depend on the threads.
class GreedyStrategy final : public SequenceStrategy {
 public:
  AssemblyPlan plan(const SequenceQuestion& question, SequenceHost& host) override;
};

}  // namespace glissade
