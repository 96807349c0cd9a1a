#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/access/hand_hold.h"
#include "engine/access/hand_way.h"
#include "engine/base/stop_token.h"
#include "engine/collision/prepared_bodies.h"

namespace glissade {

/// Whether a hand gets there.
enum class HandAccess {
  NotAsked,
  Free,     ///< one of the holds stays free at every sample: no proof of what lies between the samples
  Blocked,  ///< each of the holds meets a body at a sample
  NoGrip    ///< no place of the body fits into one hand
};

/// "not_asked", "free", "blocked", "no_grip".
const char* handAccessName(HandAccess access);

/// What is asked of the hand: bodies by their index in the prepared ones.
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
