#include <glissade/problem.h>

#include "engine/api/parameter_map.h"
#include "engine/api/values.h"
#include "engine/files/part_files.h"

namespace glissade::api {
namespace {

/// The box of the object's origin that the problem has without a stated one: room to get out, with start and goal.
Box3 roomOf(const CollisionWorld& world, const glissade::Pose& start, const glissade::Goal& goal) {
  Box3 ends(start.position, start.position);
  if (const auto* q = std::get_if<glissade::Pose>(&goal)) ends.extend(q->position);
  return roomAbout(world.obstaclesBox().merged(ends), world.objectRadius());
}

}  // namespace

Result<Problem> Problem::make(const World& world, const Pose& start, const std::optional<Pose>& goal,
                              const std::optional<Box>& bounds, const Parameters& parameters) {
  if (const auto fault = faultOfPose(start, "start")) return *fault;
  if (goal) {
    if (const auto fault = faultOfPose(*goal, "goal")) return *fault;
  }
  if (bounds) {
    const bool isBox =
        bounds->lower.allFinite() && bounds->upper.allFinite() && (bounds->upper - bounds->lower).minCoeff() >= 0.0;
    if (!isBox) return wrongArgument("bounds", "are not finite, or the lower corner is above the upper one");
  }
  return attempt<Problem>("making a problem", [&]() -> Result<Problem> {
    const CollisionWorldPtr& shared = world.impl().world;
    ParameterValues values(shared->objectRadius());
    if (const auto fault = setAll(parameters, values)) return *fault;
    glissade::Problem problem;
    problem.world = shared;
    problem.start = enginePose(start);
    if (goal) {
      problem.goal = enginePose(*goal);
    } else {
      problem.goal = GoalOut{};
    }
    problem.bounds = bounds ? Box3(bounds->lower, bounds->upper) : roomOf(*shared, problem.start, problem.goal);
    return valueOf<Problem>({std::move(problem), values});
  });
}

World Problem::world() const { return valueOf<World>({impl().problem.world}); }

Pose Problem::start() const { return publicPose(impl().problem.start); }

std::optional<Pose> Problem::goal() const {
  const auto* goal = std::get_if<glissade::Pose>(&impl().problem.goal);
  return goal == nullptr ? std::nullopt : std::optional(publicPose(*goal));
}

Box Problem::bounds() const { return publicBox(impl().problem.bounds); }

Parameters Problem::parameters() const { return publicParameters(impl().parameters); }

}  // namespace glissade::api
