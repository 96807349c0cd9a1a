#pragma once

#include "engine/collision/kernel/pair_traversal.h"
#include "engine/collision/motion_bound.h"
#include "engine/collision/surface_query.h"

namespace glissade {

/// Proves a whole straight motion by halving time: in the middle of an interval a pair of boxes is
/// ruled out for all of it if it is farther apart than the requirement and the way that the object's
/// box can go in half the interval. The first pair that cannot be ruled out ends the look: it and what
/// was not looked at yet are handed on to both halves, it first. So nothing is ruled out twice, and a
/// narrow place costs what its own pairs cost. Of triangles only the speed towards each other counts, so
/// that sliding along a surface costs no more than going through the open. Left halves come first: what is found is the
/// first violation.
class MotionSearch {
 public:
  MotionSearch(PairTraversal& traversal, const Pose& from, const Pose& to, double required);

  MotionCheck run(const StopToken& stop);

 private:
  struct Interval {
    double begin;
    double end;
    std::vector<BoxPair> pairs;  ///< not ruled out yet, the most doubtful last

    double half() const { return 0.5 * (end - begin); }
    double middle() const { return 0.5 * (begin + end); }
  };
  enum class Finding { Clear, Doubtful, Violation };

  /// The way that box may go in time `half`, metres.
  double way(BoxTree::Box box, double half) const;
  /// Rules pairs out until one cannot be: that one is left on top.
  Finding examine(Interval& interval);
  Finding examineLeaves(const BoxPair& leaves, double half, double way);
  /// The plane between the triangles at the interval's middle keeps them apart all the time.
  bool keptApart(const TrianglePair& pair, const TriangleDistance& distance, double half) const;
  bool meets(const BoxPair& leaves);

  PairTraversal& traversal_;
  const Pose& from_;
  const Pose& to_;
  Velocity velocity_;
  double speed_;  ///< of the reference point
  Pose middle_;   ///< of the interval looked at
  double required_;
};

}  // namespace glissade
