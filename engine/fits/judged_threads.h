#pragma once

#include <vector>

#include "engine/evidence/placed_bodies.h"
#include "engine/evidence/pulled_thread.h"
#include "engine/fits/fit.h"

namespace glissade {

struct AssembledProduct;

/// Threads that the judge sees in pairs with the shapes of their fits (evidence::commonThreads()). Bodies are prepared
/// once. Used by one thread.
class JudgedThreads {
 public:
  /// `partings`: pairs that may come apart without a turn.
  JudgedThreads(const AssembledProduct& product, evidence::PartingWords partings);

  /// Threads that the body leaves by turning only, because the judge refuses a pull. None for a pair whose planes touch
  /// and that no fit calls a thread, for a marked thread, if a person states that they come apart otherwise, for a
  /// hollow pair that would be refused without acceptance, and for meshes without stated faces. Not all after a stop.
  /// `fits`: of the moving body with the other body.
  std::vector<evidence::CommonThread> of(std::size_t body, std::size_t other, const std::vector<Fit>& fits,
                                         const StopToken& stop);

 private:
  bool mayBePulled(std::size_t body, std::size_t other, const std::vector<Fit>& fits);

  const AssembledProduct& product_;
  evidence::FitWords words_;
  evidence::PlacedBodies placed_;
};

}  // namespace glissade
