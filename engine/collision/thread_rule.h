#pragma once

#include <cmath>
#include <vector>

#include "engine/geometry/screw_axis.h"
#include "engine/places/rigid_body.h"

namespace glissade {

/// A thread of the object and one of an obstacle on a common axis. While they are engaged, the object makes only the
/// screw motion: a turn about the axis together with a translation by the pitch.
struct ThreadRule {
  int obstacle = -1;                  ///< index of the obstacle
  Vector3 point_W = Vector3::Zero();  ///< point on the axis
  Vector3 axis_W = Vector3::UnitZ();  ///< unit axis
  double pitch = 0.0;                 ///< advance along the axis for one turn, metres; not 0; below 0: left-handed
  double radiusOfObject = 0.0;        ///< radius of the cylinder that represents the object's thread, metres
  double radiusOfObstacle = 0.0;      ///< radius of the cylinder that represents the obstacle's thread, metres
  bool objectIsShaft = true;          ///< true: the obstacle has the hole
  bool mayTurn = true;          ///< false: the obstacle would turn with the object, so that the object cannot be moved
  std::vector<Pose> assembled;  ///< configurations in which the object's thread lies on the axis; at least one
};

/// The play as a share of the pitch: largest distance of a point of the thread from the exact screw motion.
inline constexpr double kThreadPlay = 0.02;

/// The pose after a screw motion with this advance along the axis, metres.
Pose screwed(const ThreadRule& rule, const Pose& from, double advance);

/// A threaded pair for planners, which tests whether the rule allows a configuration or a motion. Immutable, shared by
/// threads.
///
/// The thread of a shaft reaches along the axis as far as its mesh has vertices within the shaft's radius, that of a
/// hole as far as it has vertices from the hole's radius to 1.25 times the shaft's (a countersink). Two threads are
/// engaged while the axis of the shaft's thread runs through the bore of the other, or is nearer to it than the play.
class ThreadPair {
 public:
  /// `object` and `obstacle` have their complete meshes. `rule.obstacle` is the obstacle's index.
  ThreadPair(const ThreadRule& rule, const TriangleMesh& object, const RigidBody& obstacle);

  const ThreadRule& rule() const { return rule_; }

  bool engaged(const Pose& X_WB) const { return engagedWithin(X_WB, 0.0); }
  /// True if the threads are nearer than the play plus `distance`. False: no motion that moves points of the object by
  /// less than `distance` (metres) engages the threads.
  bool engagedWithin(const Pose& X_WB, double distance) const;
  /// The play: distance along the axis by which the threads stay engaged beyond their ends, metres.
  double margin() const { return kThreadPlay * std::abs(rule_.pitch); }
  /// True if a screw motion leads to this configuration from one of the assembled configurations.
  bool isOnScrew(const Pose& X_WB) const;
  /// True if the straight motion of an engaged object is one along the thread.
  bool isScrewMotion(const Pose& from, const Pose& to) const;
  /// True if all configurations of a screw motion from `from` are on the rule's screw motion, even where points of the
  /// object are off the motion by `off` (metres).
  bool permitsScrew(const Pose& from, const ScrewAxis& screw, double advance, double off) const;
  /// Advance along the axis after which the threads are no longer engaged, in one sense (`sense` 1) or the other (-1),
  /// metres; 0 where they are not engaged.
  double advanceOut(const Pose& from, double sense) const;
  /// Distance along the axis from one configuration to another, metres.
  double advanceBetween(const Pose& from, const Pose& to) const;
  /// True if the object's thread is in the same place, within its play.
  bool isSame(const Pose& one, const Pose& other) const { return offBy(one, other) <= play(); }

 private:
  /// A range along the thread's axis, metres.
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
  Span object_;    ///< range from point_B along axis_B
  Span obstacle_;  ///< range from point_W along axis_W
};

/// Full turns of the object about the axis on the edges that begin or end engaged, right-handed.
double turnsWhileEngaged(const ThreadPair& pair, const std::vector<Pose>& path);

}  // namespace glissade
