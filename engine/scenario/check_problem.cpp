#include "engine/scenario/check_problem.h"

namespace glissade {
namespace {

Outcome checkFree(const LoadedScenario& scenario, CollisionQuery& query, const std::string& which, const Pose& q) {
  const std::optional<int> body = query.collidingBody(q);
  if (!body) return Done{};
  const RigidBody& obstacle = scenario.problem.world->obstacles()[static_cast<std::size_t>(*body)];
  return Diagnostic{ErrorKind::InCollision, scenario.file, which,
                    "the object '" + scenario.object.name + "' penetrates '" + obstacle.name + "'",
                    "Move the " + which + " or the body so that they do not touch."};
}

}  // namespace

Outcome checkStartAndGoal(const LoadedScenario& scenario) {
  const std::unique_ptr<CollisionQuery> query = scenario.problem.world->makeQuery();
  const Outcome start = checkFree(scenario, *query, "start", scenario.problem.start);
  const Pose* goal = std::get_if<Pose>(&scenario.problem.goal);
  if (!start || !goal) return start;
  return checkFree(scenario, *query, "goal", *goal);
}

}  // namespace glissade
