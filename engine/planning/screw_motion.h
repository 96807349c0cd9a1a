#pragma once

#include <string>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/collision/collision_query.h"
#include "engine/planning/path.h"

namespace glissade {

/// A screw motion by which the object leaves all threads that it is engaged in.
struct ScrewWay {
  std::vector<Pose> configurations;  ///< straight motions between them keep the rule of the threads
  Vector3 direction_W;               ///< of the advance, unit
  double turns = 0.0;                ///< about that direction, by the right hand
};

/// The screw motions out of the threads that the object is engaged in.
struct ScrewSearch {
  bool engaged = false;        ///< the object is in a thread at all
  std::vector<ScrewWay> ways;  ///< free ones, the shortest first; at most one for each sense
  std::vector<int> blockedBy;  ///< obstacles in the way of the others, or that hold the object; ascending
  std::string why;             ///< where there is no way: why, with names of obstacles
};

/// Looks for both senses. Every motion keeps the required clearance (metres), as `query` says, which asks `world`.
ScrewSearch findScrewWays(const CollisionWorld& world, CollisionQuery& query, const Pose& from, double required,
                          const StopToken& stop);

/// The screw motion from one configuration in a thread to another one in the same; empty where none leads there or it
/// is not free.
std::vector<Pose> screwBetween(const CollisionWorld& world, CollisionQuery& query, const Pose& from, const Pose& to,
                               double required, const StopToken& stop);

/// The configurations as points of a path that the computer found.
std::vector<PathPoint> computedPoints(const std::vector<Pose>& configurations);

}  // namespace glissade
