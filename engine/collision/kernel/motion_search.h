#pragma once

#include <optional>

#include "engine/collision/kernel/pair_traversal.h"
#include "engine/collision/motion_bound.h"
#include "engine/collision/surface_query.h"
#include "engine/geometry/straight_motion.h"

namespace glissade {

/// Proves a whole straight motion by halving time. In the middle of an interval a pair of boxes is ruled
/// out for all of it if some axis keeps them apart while the object's box goes its way to both sides:
/// only the speed along that axis counts, so that sliding along a surface costs no more than going
/// through the open. What is large for the way it goes is opened, what is small waits for both halves;
/// so nothing is ruled out twice, and a narrow place costs what its own pairs cost. Left halves come
/// first: what is found is the first violation. The pair that violated last is looked at first.
class MotionSearch {
 public:
  /// Memory that searches use one after the other.
  struct Stacks {
    std::vector<PairTraversal::Opened> doubts;
    std::vector<PairTraversal::Opened> open;
  };

  MotionSearch(PairTraversal& traversal, Stacks& stacks, const Pose& from, const Pose& to, double required,
               SeekViolation seek);

  MotionCheck run(const StopToken& stop);

 private:
  using Opened = PairTraversal::Opened;

  struct Interval {
    double begin;
    double end;

    double half() const { return 0.5 * (end - begin); }
    double middle() const { return 0.5 * (begin + end); }
  };
  /// A run in `doubts_`.
  struct Doubts {
    std::size_t begin;
    std::size_t end;
  };
  enum class Finding { Clear, Doubtful, Violation };

  /// False where it is not: then `check_` says why.
  bool prove(const Interval& interval, const Doubts& doubts, const StopToken& stop);
  /// Appends to `doubts_` the doubts that remain in this interval or were not examined. Returns false if the middle of
  /// the interval violates the requirement.
  bool examine(const Interval& interval, const Doubts& doubts);
  bool examine(Opened opened, double half);
  Finding examine(const BoxPair& leaves, double half);
  Finding examine(const TrianglePair& pair, double half, double way);
  /// At the interval's middle; nothing where it violates the requirement.
  std::optional<TriangleDistance> allowedDistance(const TrianglePair& pair) const;
  /// The plane between the triangles at the interval's middle keeps them apart all the time.
  bool keptApart(const TrianglePair& pair, const TriangleDistance& distance, double half) const;
  double sizeOf(const BoxPair& pair) const;

  PairTraversal& traversal_;
  StraightMotion motion_;
  Velocity velocity_;
  double longest_;  ///< way of any point in all the time
  Pose middle_;     ///< of the interval looked at
  Vector3 spin_W_ = Vector3::Zero();
  double required_;
  SeekViolation seek_;
  MotionCheck check_;
  std::vector<Opened>& doubts_;
  std::vector<Opened>& open_;
  std::optional<TrianglePair> violating_;  ///< the last that was found
};

}  // namespace glissade
