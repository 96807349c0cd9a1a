#pragma once

#include <variant>

#include "engine/collision/collision_query.h"
#include "engine/geometry/se3_metric.h"

namespace glissade {

/// Goal "out": any configuration whose object is clear of the others' bounding box.
struct GoalOut {};
using Goal = std::variant<Pose, GoalOut>;

/// One planning question. Immutable; shared by threads.
struct Problem {
  CollisionWorldPtr world;
  Pose start;
  Goal goal;
  Box3 bounds;  ///< of the object's reference point, world frame

  Se3Metric metric() const { return Se3Metric(world->objectRadius()); }
};

}  // namespace glissade
