#pragma once

#include "engine/sequence/searched_removal.h"
#include "engine/sequence/straight_removal.h"
#include "engine/sequence/turned_removal.h"

namespace glissade {

/// Asks the collision kernel and the planners: effort 0 is straight lines and turns out of threads, the others are
/// searches, each with four times the budget of the one before.
class MotionTrial final : public RemovalTrial {
 public:
  /// Levels of search, at most.
  static constexpr int kMostSearches = 4;

  /// Refers to product and fits. `searches`: levels of search beside the straight lines, from 0 to kMostSearches.
  MotionTrial(const AssembledProduct& product, const ProductFits& fits, std::uint64_t seed,
              int searches = kMostSearches);

  int efforts() const override { return 1 + searches_; }
  RemovalAnswer tryRemoval(std::size_t body, const BodySet& present, int effort, const StopToken& stop) override;
  void learn(std::size_t body, const std::vector<PathPoint>& path) override;

 private:
  RemovalAnswer tryDirectly(std::size_t body, const BodySet& present, const StopToken& stop);

  const ProductFits& fits_;
  int searches_;
  PreparedBodies prepared_;
  StraightRemoval straight_;
  TurnedRemoval turned_;
  SearchedRemoval searched_;
};

}  // namespace glissade
