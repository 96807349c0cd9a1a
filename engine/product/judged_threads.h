#pragma once

#include <vector>

#include "engine/check/placed_bodies.h"
#include "engine/check/pulled_thread.h"
#include "engine/product/fit.h"

namespace glissade {

struct AssembledProduct;

/// Threads that the judge sees in pairs that are taken as their fits say (check::commonThreads()). Bodies are looked at
/// once. Of one thread.
class JudgedThreads {
 public:
  explicit JudgedThreads(const AssembledProduct& product);

  /// Those that the body leaves the other one by turning only: the judge refuses a pull. None where nothing of either
  /// is taken away or thinner, where a person says that they come apart otherwise or marks the thread, and where their
  /// meshes state no faces. `fits`: of the moving body with the other one.
  std::vector<check::CommonThread> of(std::size_t body, std::size_t other, const std::vector<Fit>& fits);

 private:
  check::Body bodyAt(std::size_t index) const;
  bool mayBePulled(std::size_t body, std::size_t other, const std::vector<Fit>& fits);

  const AssembledProduct& product_;
  check::FitWords words_;
  check::PlacedBodies placed_;
};

}  // namespace glissade
