#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/access/hand_hold.h"
#include "engine/base/stop_token.h"
#include "engine/collision/prepared_bodies.h"
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
  /// The hand moves rigidly with the body.
  static HandFollow rigidly() { return HandFollow(); }
  /// The hand follows this point of the body but not its turns, as fingers that grip again and again.
  static HandFollow point(const Vector3& p_W);
  /// The hand does not move: it turns a bolt that stays.
  static HandFollow still();

  /// The motion of the hand when the body has moved by `moved`.
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

/// Whether a hand gets there.
enum class HandAccess {
  NotAsked,
  Free,     ///< one of the holds stays free at every sample: no proof of what lies between the samples
  Blocked,  ///< each of the holds meets a body at a sample
  NoGrip    ///< no place of the body fits into one hand
};

inline constexpr EnumNames<HandAccess, 4> kHandAccessNames{{"not_asked", "free", "blocked", "no_grip"}};

/// A question about the hand. Bodies are given by their index in the prepared ones.
struct HandQuestion {
  std::vector<HandHold> holds;         ///< tried in this order
  std::vector<HandSample> samples;     ///< one or more
  std::vector<std::size_t> gripped;    ///< bodies that the hand and the forearm may not go through at the first sample
  std::vector<std::size_t> obstacles;  ///< bodies that hand, forearm and tool may not touch
  std::vector<HandHold> pushes{};      ///< with which the hand may push instead, near the place
  std::size_t pushed = 0;              ///< so many samples from the first one; below the number of samples
};

struct HandAnswer {
  HandAccess access = HandAccess::NotAsked;
  /// The one that stays free. Else, of the most natural ones, the one that comes nearest to the place from the end of
  /// the way; unless NoGrip.
  HandHold hold;
  std::vector<std::optional<std::size_t>>
      bends;                               ///< of wristBends(), at each sample; nothing: blocked there, or before
  double share = 0.0;                      ///< of the way from the place, where the hand is blocked; of a free one 0
  std::optional<std::size_t> blockedBy{};  ///< body that it meets there
  std::size_t tried = 0;                   ///< holds
  /// The body goes into its place by a push: at so many samples from the first one, the hand is held so.
  std::optional<HandHold> push{};
  std::size_t pushed = 0;

  const HandHold& holdAt(std::size_t sample) const { return sample < pushed ? *push : hold; }
};

/// Looks for a hold with which hand, forearm and tool stay free at every sample, or for one that does so beyond those
/// samples at which a push does; at each sample the wrist may be bent otherwise. For one person's hand and one thread.
/// The prepared bodies must outlive it.
class HandSearch {
 public:
  HandSearch(PreparedBodies& bodies, HandSize size) : bodies_(bodies), shapes_(size) {}

  HandShapes& shapes() { return shapes_; }
  /// After a stop: NotAsked.
  HandAnswer find(const HandQuestion& question, const StopToken& stop);

 private:
  PreparedBodies& bodies_;
  HandShapes shapes_;
};

}  // namespace glissade
