#include "engine/scenario/hand_run.h"

#include <algorithm>

#include "engine/base/file.h"
#include "engine/import/geometry_loader.h"
#include "engine/scenario/assembly_edits.h"
#include "engine/scenario/reference_point.h"

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

/// Where the body turns about in a product: see AssembledProduct. World frame.
Vector3 middleOf(const std::string& id, const LoadedScenario& loaded) {
  const auto known = std::find_if(loaded.obstacles.begin(), loaded.obstacles.end(),
                                  [&](const RigidBody& body) { return body.id == id; });
  const RigidBody& body = known == loaded.obstacles.end() ? loaded.object : *known;
  return body.X_WB * Vector3(boundingBox(*body.mesh, Pose::identity()).center());
}

/// The object stays where it is. Motions between two configurations depend on the point that an object turns about.
void turnAbout(const Vector3& point_W, const LoadedScenario& loaded, Scenario& scenario) {
  ObjectDescription& object = scenario.object;
  const auto& geometry =
      *loaded.geometry.at(geometryKey(object.geometry, loaded.scenario.assets, folderOf(loaded.file)));
  const Pose X_WG = scenario.start * Pose::translation(-referencePointOf(object, geometry));
  object.centreOnVertexMean = false;
  object.referencePoint = inverse(X_WG) * point_W;
  scenario.start = X_WG * Pose::translation(object.referencePoint);
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
  turnAbout(middleOf(moving, loaded), loaded, scenario);
  scenario.goal = GoalOut{};
  for (const std::string& id : gone) {
    const Outcome removed = removeBody(bodyIdOf(id), scenario);
    if (!removed) return removed;
  }
  return Done{};
}

DemandedMotion motionOfRun(const RigidBody& body, const std::vector<PathPoint>& path, const std::string& planner) {
  // Samples in contact are drawn about the object in the hand.
  const bool steered = std::any_of(path.begin(), path.end(), [](const PathPoint& point) {
    return point.author != Author::Computer || point.segmentAuthor != Author::Computer;
  });
  DemandedMotion motion{{body.id}, {}, steered || planner.empty() ? kByHand : planner};
  const Pose X_OB = inverse(path.front().q) * body.X_WB;
  for (const PathPoint& point : path) {
    motion.path.push_back({point.q * X_OB, point.author, point.segmentAuthor});
    motion.path.back().q.orientation.normalize();
  }
  motion.path.front().q = body.X_WB;
  return motion;
}

}  // namespace glissade
