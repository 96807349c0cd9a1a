#pragma once

#include <vector>

#include "engine/base/stop_token.h"
#include "engine/check/motion_check.h"

namespace glissade::check {

/// Whether a path keeps to its threads: searches each thread's extent, follows the turn from edge to edge, and compares
/// the thread's ends with where the screw motion from the edge where it was engaged first has them.
class ThreadMotion {
 public:
  ThreadMotion(const std::vector<MotionCheck::Threaded>& threads, const TriangleMesh& object);

  struct Edge {
    bool engaged = false;            ///< or not shown to be disengaged on all of it
    const Thread* thread = nullptr;  ///< one of those that it turns in; null: none
    int forbiddenBy = -1;            ///< obstacle of an engaged thread in which the edge is no screw motion
  };
  /// Of each edge of the path, up to the first that is forbidden, or a stop; a path of one configuration is an edge.
  std::vector<Edge> judge(const std::vector<Pose>& path, const StopToken& stop) const;

 private:
  struct Extent {
    Thread thread;
    Vector3 low_B;  ///< ends of the object's thread, in its frame
    Vector3 high_B;
    Vector3 low_W;  ///< ends of the obstacle's
    Vector3 high_W;
    double reach;  ///< largest distance of the object's points from its reference point
  };
  /// Since the thread was engaged.
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
