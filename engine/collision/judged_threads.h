#pragma once

#include <vector>

#include "engine/collision/thread_rule.h"

namespace glissade {

/// The independent check's own test of threads, after the definition at ThreadPair. Shares nothing with it but the
/// rule's values: it searches the thread's extent, follows the turn from edge to edge, and compares the thread's ends
/// with where the screw motion from the edge where it was engaged first has them.
class JudgedThreads {
 public:
  JudgedThreads(const std::vector<ThreadRule>& rules, const TriangleMesh& object,
                const std::vector<RigidBody>& obstacles);

  struct Edge {
    bool engaged = false;                ///< or not shown to be disengaged on all of it
    const ThreadRule* thread = nullptr;  ///< one of those that it turns in; null: none
    int forbiddenBy = -1;                ///< obstacle of an engaged thread in which the edge is no screw motion
  };
  /// Of each edge of the path, up to the first that is forbidden; a path of one configuration is an edge.
  std::vector<Edge> judge(const std::vector<Pose>& path) const;

 private:
  struct Thread {
    ThreadRule rule;
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

  static double separation(const Thread& thread, const Pose& X_WB);
  static bool staysApart(const Thread& thread, const Pose& from, const Pose& to);
  static bool isTurn(const Thread& thread, const Pose& from, const Pose& to, Followed& followed);

  std::vector<Thread> threads_;
};

}  // namespace glissade
