#pragma once

#include "engine/collision/prepared_bodies.h"
#include "engine/sequence/product_fits.h"
#include "engine/sequence/removal_trial.h"

namespace glissade {

/// Removal of a body that is in threads: turned out of them by a screw motion, then straight on along their axis.
class TurnedRemoval {
 public:
  TurnedRemoval(const AssembledProduct& product, const ProductFits& fits, PreparedBodies& prepared)
      : product_(product), fits_(fits), prepared_(prepared) {}

  /// As RemovalTrial::tryRemoval(). A body that is in no thread is refused by nobody.
  RemovalAnswer tryRemoval(std::size_t body, const BodySet& present, const StopToken& stop) const;

 private:
  const AssembledProduct& product_;
  const ProductFits& fits_;
  PreparedBodies& prepared_;
};

}  // namespace glissade
