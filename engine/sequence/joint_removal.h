#pragma once

#include <map>
#include <mutex>
#include <optional>

#include "engine/geometry/screw_axis.h"
#include "engine/sequence/joint_rules.h"
#include "engine/sequence/motion_world.h"
#include "engine/sequence/removal_trial.h"

namespace glissade {

/// StepMotion::method of bodies that turn out of a joint or a marked thread.
inline constexpr const char* kTurned = "turned";

/// Removal of a group that closed joints hold by their threads: it turns about the axis by the joint's pitch until the
/// threads are free, then moves straight on; where that is not free, by the other end of a rod without a head. The
/// turns are proved for all angles at once (see certifyPath), because a turning body stays in its solid of revolution.
/// A thread is not pulled, so no other motion is tried. A refusal holds while the bodies that it names are there, and
/// is stored. Thread-safe.
class JointRemoval {
 public:
  /// Refers to all arguments.
  JointRemoval(const AssembledProduct& product, const ProductFits& fits, MotionWorlds& worlds, const JointRules& rules)
      : product_(product), fits_(fits), worlds_(worlds), rules_(rules) {}

  /// `opened`: the result of JointRules::opened(), not empty.
  RemovalAnswer tryRemoval(const BodyGroup& group, const BodySet& present, const std::vector<std::size_t>& opened,
                           const StopToken& stop);
  /// The configurations of the turn out of the opened joints, until the threads are free; empty if it is not free.
  std::vector<Pose> turnOut(const BodyGroup& group, const BodySet& present, const std::vector<std::size_t>& opened);

 private:
  /// A turn that all opened joints allow.
  struct Turn {
    ScrewAxis screw;
    double advance = 0.0;  ///< metres along the axis, above 0
  };
  std::optional<Turn> commonTurn(const BodyGroup& group, const std::vector<std::size_t>& opened) const;
  std::optional<Turn> otherEnd(const Turn& turn, const BodyGroup& group, const BodySet& present,
                               const std::vector<std::size_t>& opened);
  RemovalAnswer tryTurn(const BodyGroup& group, const BodySet& present, const Turn& turn, const StopToken& stop);
  std::optional<Refused> known(const BodyGroup& group, const BodySet& present) const;
  static bool turnIsFree(CollisionQuery& query, const Turn& turn, const MovingObject& object);
  RemovalAnswer leaveAfter(const std::vector<Pose>& turned, const Vector3& axis, const BodyGroup& group,
                           const BodySet& present, const StopToken& stop);
  Box3 othersBox(const BodyGroup& group) const;
  static Pose outOf(const Box3& others, Pose from, const Vector3& direction, const MovingObject& object);
  std::vector<std::size_t> blockersOf(const BodyGroup& group, const BodySet& present, const Turn& turn,
                                      const std::pair<Pose, Pose>& on, const StopToken& stop);

  const AssembledProduct& product_;
  const ProductFits& fits_;
  MotionWorlds& worlds_;
  const JointRules& rules_;
  mutable std::mutex mutex_;              ///< protects the members below
  std::map<BodyGroup, Refused> refused_;  ///< the last refusal
};

/// Configurations of a screw motion from there, by an advance along the axis, metres: enough of them that no point of a
/// body whose frame is off the axis leaves the helix by more than `off`, metres.
std::vector<Pose> turnedAlong(const ScrewAxis& screw, const Pose& from, double advance, double off);

}  // namespace glissade
