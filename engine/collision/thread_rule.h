#pragma once

#include <cmath>
#include <vector>

#include "engine/environment/rigid_body.h"
#include "engine/geometry/screw_axis.h"

namespace glissade {

/// A thread of the object and one of an obstacle on a common axis. While they are engaged, the object moves by the
/// screw motion only: a turn about the axis together with a translation by the pitch.
struct ThreadRule {
  int obstacle = -1;                  ///< index
  Vector3 point_W = Vector3::Zero();  ///< on the axis
  Vector3 axis_W = Vector3::UnitZ();  ///< unit
  double pitch = 0.0;                 ///< metres along the axis for a turn about it; not 0; below 0: left-handed
  double radiusOfObject = 0.0;        ///< of the cylinder that stands for the object's thread, metres
  double radiusOfObstacle = 0.0;      ///< the same of the obstacle
  bool objectIsShaft = true;          ///< the obstacle has the hole then
  bool mayTurn = true;                ///< false: the obstacle would turn with the object, which cannot be moved
  std::vector<Pose> assembled;        ///< configurations in which the object's thread is on the axis; at least one
};

/// The play, as a share of the pitch: by which a point of the thread may be off the exact screw motion.
inline constexpr double kThreadPlay = 0.02;

/// Where a screw motion has the object after it has advanced along the axis from there, metres.
Pose screwed(const ThreadRule& rule, const Pose& from, double advance);

/// A threaded pair for planners: which configurations and motions the rule allows. Immutable, shared by threads.
///
/// The thread of a shaft reaches along the axis as far as its mesh has vertices within the shaft's radius, that of a
/// hole as far as there are vertices from the hole's radius to 1.25 times the shaft's (a countersink). Two threads are
/// engaged while the axis of the shaft's thread runs through the bore of the other, or is nearer to it than the play.
class ThreadPair {
 public:
  /// The meshes are the true ones. `rule.obstacle` is the obstacle's index.
  ThreadPair(const ThreadRule& rule, const TriangleMesh& object, const RigidBody& obstacle);

  const ThreadRule& rule() const { return rule_; }

  bool engaged(const Pose& X_WB) const { return engagedWithin(X_WB, 0.0); }
  /// Nearer than the play, or than the distance more. False: no motion that moves points of the object by less than the
  /// distance (metres) engages the threads.
  bool engagedWithin(const Pose& X_WB, double distance) const;
  /// Metres along the axis by which the threads are engaged beyond their ends: the play.
  double margin() const { return kThreadPlay * std::abs(rule_.pitch); }
  /// A screw motion leads there from one of the assembled configurations.
  bool isOnScrew(const Pose& X_WB) const;
  /// The straight motion is one along the thread, for one that is engaged.
  bool isScrewMotion(const Pose& from, const Pose& to) const;
  /// All configurations of a screw motion from there are on the rule's, also where points of the object are off the
  /// motion by `off` (metres).
  bool permitsScrew(const Pose& from, const ScrewAxis& screw, double advance, double off) const;
  /// Advance along the axis after which the threads are no longer engaged, one way (`sense` 1) or the other (-1),
  /// metres; 0 where they are not engaged.
  double advanceOut(const Pose& from, double sense) const;
  /// Metres along the axis from one configuration to another.
  double advanceBetween(const Pose& from, const Pose& to) const;
  /// The object's thread is in the same place, within its play.
  bool isSame(const Pose& one, const Pose& other) const { return offBy(one, other) <= play(); }

 private:
  /// Along the thread's axis, metres.
  struct Span {
    double low;
    double high;
  };
  bool isOnScrewOf(const Pose& X_WB, const Pose& assembled) const;
  double play() const;
  double offBy(const Pose& X_WB, const Pose& exact) const;
  Pose nearestOnScrew(const Pose& X_WB, const Pose& assembled) const;

  ThreadRule rule_;
  Vector3 point_B_;
  Vector3 axis_B_;
  Span object_;    ///< from point_B, along axis_B
  Span obstacle_;  ///< from point_W, along axis_W
};

/// Full turns of the object about the axis on the edges that begin or end engaged, by the right hand.
double turnsWhileEngaged(const ThreadPair& pair, const std::vector<Pose>& path);

}  // namespace glissade
