#pragma once

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// Works in waves. Straight motions are tried for all bodies, and bodies that can leave do so, the smallest first. If
/// none can, some bodies are tried with more effort. A refused body is tried again with the same effort only after one
/// of the bodies that block it has left. The number of bodies that are tried at the same time does not depend on the
/// threads.
class GreedyStrategy final : public SequenceStrategy {
 public:
  AssemblyPlan plan(const SequenceQuestion& question, SequenceHost& host) override;
};

}  // namespace glissade
