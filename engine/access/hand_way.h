#pragma once

#include <vector>

#include "engine/geometry/pose.h"

namespace glissade {

/// A configuration of a motion at which a hand is looked at.
struct HandSample {
  Pose moved;          ///< the hand stands at moved * X_WH
  double share = 0.0;  ///< of the way
};

/// How a hand goes with what it moves.
class HandFollow {
 public:
  /// As one rigid body with it.
  static HandFollow rigidly() { return HandFollow(); }
  /// Without its turns, as fingers that grip again and again: what is at this point stays in the hand.
  static HandFollow point(const Vector3& p_W);
  /// Not at all: it turns a bolt that stays.
  static HandFollow still();

  /// Where the hand has moved to when the body has moved so.
  Pose movedWith(const Pose& moved) const;

 private:
  enum class Kind { Rigidly, Point, Still };
  Kind kind_ = Kind::Rigidly;
  Vector3 p_W_ = Vector3::Zero();
};

/// A body that turns by more than half a turn on its way is gripped again and again, about `middle_W`.
HandFollow followOf(const std::vector<Pose>& moved, const Vector3& middle_W);

/// Samples of a straight motion from pose to pose, `moved`, such that no point within 0.3 m of `middle_W` moves more
/// than a centimetre between two of them, or 400 of a longer way. `moved` has one entry or more.
std::vector<HandSample> samplesOf(const std::vector<Pose>& moved, const HandFollow& follow, const Vector3& middle_W);

}  // namespace glissade
