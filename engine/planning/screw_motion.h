#pragma once

#include <string>
#include <vector>

#include "engine/base/message.h"
#include "engine/base/stop_token.h"
#include "engine/collision/collision_query.h"
#include "engine/planning/path.h"

namespace glissade {

/// A screw motion by which the object leaves all threads in which it is engaged.
struct ScrewWay {
  std::vector<Pose> configurations;  ///< configurations; the straight motions between them keep the rule of the threads
  Vector3 direction_W;               ///< direction of the advance, unit
  double turns = 0.0;                ///< turns about that direction, right-handed
};

/// The screw motions out of the threads in which the object is engaged.
struct ScrewSearch {
  bool engaged = false;        ///< the object is in at least one thread
  std::vector<ScrewWay> ways;  ///< free motions, the shortest first; at most one for each sense
  std::vector<int> blockedBy;  ///< obstacles that block the other motions, or hold the object; ascending
  Message why;                 ///< reason, with names of obstacles, where there is no motion
};

/// Searches in both senses. Every motion keeps the required clearance (metres) by `query`, which queries `world`.
ScrewSearch findScrewWays(const CollisionWorld& world, CollisionQuery& query, const Pose& from, double required,
                          const StopToken& stop);

/// The screw motion from one configuration in a thread to another one in the same thread; empty where there is none or
/// it is not free.
std::vector<Pose> screwBetween(const CollisionWorld& world, CollisionQuery& query, const Pose& from, const Pose& to,
                               double required, const StopToken& stop);

/// The configurations as path points whose author is the computer.
std::vector<PathPoint> computedPoints(const std::vector<Pose>& configurations);

}  // namespace glissade
