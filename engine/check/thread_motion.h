#pragma once

#include <vector>

#include "engine/base/stop_token.h"
#include "engine/check/motion_check.h"

namespace glissade::check {

/// Checks whether a path keeps to its threads: finds the extent of each thread, follows the turn from edge to edge, and
/// compares the thread's ends with the screw motion from the first engaged edge.
class ThreadMotion {
 public:
  ThreadMotion(const std::vector<MotionCheck::Threaded>& threads, const TriangleMesh& object);

  struct Edge {
    bool engaged = false;            ///< the thread is engaged, or not shown to be disengaged on the whole edge
    const Thread* thread = nullptr;  ///< a thread in which the edge turns; null: none
    int forbiddenBy = -1;            ///< obstacle of an engaged thread in which the edge is no screw motion; -1: none
  };
  /// One entry for each edge of the path, up to the first forbidden edge, or a stop; a path of one configuration is an
  /// edge.
  std::vector<Edge> judge(const std::vector<Pose>& path, const StopToken& stop) const;

 private:
  struct Extent {
    Thread thread;
    Vector3 low_B;  ///< ends of the object's thread, in the object's frame
    Vector3 high_B;
    Vector3 low_W;  ///< ends of the obstacle's thread, world frame
    Vector3 high_W;
    double reach;  ///< largest distance of the object's points from its reference point
  };
  /// The turn since the thread was engaged.
  struct Followed {
    bool engaged = false;
    Pose first;
    double turn = 0.0;  ///< radians
  };

  static double separation(const Extent& thread, const Pose& X_WB);
  static bool staysApart(const Extent& thread, const Pose& from, const Pose& to);
  static bool isTurn(const Extent& thread, const Pose& from, const Pose& to, Followed& followed);

  std::vector<Extent> threads_;
};

}  // namespace glissade::check
