#include "engine/scenario/hand_run.h"

#include <algorithm>

#include "engine/scenario/assembly_edits.h"

namespace glissade {
namespace {

Outcome checkWhole(const std::string& id, const LoadedScenario& loaded) {
  const std::string body = bodyIdOf(id);
  const auto parts = std::count_if(loaded.obstacles.begin(), loaded.obstacles.end(),
                                   [&](const RigidBody& each) { return bodyIdOf(each.id) == body; });
  if (parts < 2) return Done{};
  return Diagnostic{ErrorKind::Usage, loaded.file, "body '" + body + "'",
                    "is several parts in one body of the scenario, of which '" + id + "' cannot be moved alone",
                    "Make a scenario that has each part as a body: New from parts does so with STEP files."};
}

}  // namespace

Outcome prepareHandRun(const std::string& moving, const std::vector<std::string>& gone, const LoadedScenario& loaded,
                       Scenario& scenario) {
  for (const std::string& id : gone) {
    if (const Outcome whole = checkWhole(id, loaded); !whole) return whole;
  }
  if (moving != loaded.object.id) {
    if (const Outcome whole = checkWhole(moving, loaded); !whole) return whole;
    const Outcome marked = markMoving(bodyIdOf(moving), loaded, scenario);
    if (!marked) return marked;
  }
  scenario.goal = GoalOut{};
  for (const std::string& id : gone) {
    const Outcome removed = removeBody(bodyIdOf(id), scenario);
    if (!removed) return removed;
  }
  return Done{};
}

DemandedMotion motionByHand(const RigidBody& body, const std::vector<PathPoint>& path) {
  DemandedMotion motion{{body.id}, {}, kByHand};
  const Pose X_OB = inverse(path.front().q) * body.X_WB;
  for (const PathPoint& point : path) {
    motion.path.push_back({point.q * X_OB, point.author, point.segmentAuthor});
    motion.path.back().q.orientation.normalize();
  }
  motion.path.front().q = body.X_WB;
  return motion;
}

}  // namespace glissade
