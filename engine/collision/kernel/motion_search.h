#pragma once

#include "engine/collision/kernel/pair_traversal.h"
#include "engine/collision/motion_bound.h"
#include "engine/collision/surface_query.h"

namespace glissade {

/// Proves a whole straight motion by halving time: in the middle of an interval a pair of boxes is
/// ruled out for all of it if it is farther apart than the requirement and the way that the object's
/// box can go in half the interval. What is not ruled out is handed on to both halves, so that the
/// short intervals look at few pairs. Left halves come first: what is found is the first violation.
class MotionSearch {
 public:
  MotionSearch(PairTraversal& traversal, const Pose& from, const Pose& to, double required);

  MotionCheck run(const StopToken& stop);

 private:
  struct Interval {
    double begin;
    double end;
    std::size_t firstPair;  ///< those not ruled out are pairs_[firstPair, lastPair)
    std::size_t lastPair;
  };

  /// The way that box may go in time `half`, metres.
  double way(BoxTree::Box box, double half) const;
  /// Appends the pairs that are not ruled out; false where one is nearer than required.
  bool examine(const Interval& interval);
  /// As examine, for two leaves.
  bool examineLeaves(const BoxPair& leaves, double way);
  bool meets(const BoxPair& leaves);

  PairTraversal& traversal_;
  const Pose& from_;
  const Pose& to_;
  Velocity velocity_;
  double required_;
  std::vector<BoxPair> pairs_;
  std::vector<BoxPair> stack_;
};

}  // namespace glissade
