#include "engine/scenario/assembly_edits.h"

#include <algorithm>

#include "engine/base/file.h"
#include "engine/import/geometry_loader.h"
#include "engine/scenario/part_files.h"
#include "engine/scenario/reference_point.h"

namespace glissade {
namespace {

Diagnostic refusal(const std::string& location, const std::string& reason, const std::string& advice) {
  return {ErrorKind::Usage, "", location, reason, advice};
}

Diagnostic noSuchBody(const std::string& id) {
  return refusal("body '" + id + "'", "there is no such body", "Choose one of the scene panel.");
}

std::vector<BodyDescription>::iterator findBody(const std::string& id, Scenario& scenario) {
  return std::find_if(scenario.bodies.begin(), scenario.bodies.end(),
                      [&](const BodyDescription& body) { return body.id == id; });
}

bool uses(const Geometry& geometry, const Asset& asset) {
  const std::string* id = assetOf(geometry);
  return id != nullptr && *id == asset.id;
}

void dropUnusedAssets(Scenario& scenario) {
  const auto isUnused = [&](const Asset& asset) {
    return !uses(scenario.object.geometry, asset) &&
           std::none_of(scenario.bodies.begin(), scenario.bodies.end(),
                        [&](const BodyDescription& body) { return uses(body.geometry, asset); });
  };
  scenario.assets.erase(std::remove_if(scenario.assets.begin(), scenario.assets.end(), isUnused),
                        scenario.assets.end());
}

const LoadedGeometry& geometryOf(const Geometry& geometry, const LoadedScenario& loaded) {
  return *loaded.geometry.at(geometryKey(geometry, loaded.scenario.assets, folderOf(loaded.file)));
}

/// From the frame of an object's geometry to that about its reference point.
Pose toReferencePoint(const ObjectDescription& object, const LoadedScenario& loaded) {
  return Pose::translation(referencePointOf(object, geometryOf(object.geometry, loaded)));
}

/// About the bodies, and the object where it starts.
Box3 boxOfAll(const LoadedScenario& loaded) {
  Box3 box = boundingBox(*loaded.object.mesh, loaded.problem.start);
  for (const RigidBody& body : loaded.obstacles) box.extend(boundingBox(*body.mesh, body.X_WB));
  return box;
}

}  // namespace

std::optional<Pose> poseOf(const Scenario& scenario, const AssemblyItem& item) {
  if (item.kind == AssemblyItem::Kind::Start) return scenario.start;
  if (item.kind == AssemblyItem::Kind::Goal) {
    const Pose* goal = std::get_if<Pose>(&scenario.goal);
    return goal != nullptr ? std::optional<Pose>(*goal) : std::nullopt;
  }
  for (const BodyDescription& body : scenario.bodies) {
    if (body.id == item.bodyId) return body.pose;
  }
  return std::nullopt;
}

Outcome place(const AssemblyItem& item, const Pose& X_WB, Scenario& scenario) {
  if (!isValid(X_WB)) return refusal("", "this is not a position in space", "Give finite numbers.");
  if (item.kind == AssemblyItem::Kind::Start) {
    scenario.start = X_WB;
  } else if (item.kind == AssemblyItem::Kind::Goal) {
    scenario.goal = X_WB;
  } else {
    const auto body = findBody(item.bodyId, scenario);
    if (body == scenario.bodies.end()) return noSuchBody(item.bodyId);
    body->pose = X_WB;
  }
  return Done{};
}

Outcome removeBody(const std::string& bodyId, Scenario& scenario) {
  const auto body = findBody(bodyId, scenario);
  if (body == scenario.bodies.end()) return noSuchBody(bodyId);
  scenario.bodies.erase(body);
  std::erase_if(scenario.fits.pairs,
                [&](const FitEdit& edit) { return bodyIdOf(edit.a) == bodyId || bodyIdOf(edit.b) == bodyId; });
  dropUnusedAssets(scenario);
  return Done{};
}

Outcome swapEnds(Scenario& scenario) {
  Pose* goal = std::get_if<Pose>(&scenario.goal);
  if (goal == nullptr)
    return refusal("goal", "the goal is \"out\", which has no position", "Give the goal a position first.");
  std::swap(scenario.start, *goal);
  return Done{};
}

Outcome markMoving(const std::string& bodyId, const LoadedScenario& loaded, Scenario& scenario) {
  const auto body = findBody(bodyId, scenario);
  if (body == scenario.bodies.end()) return noSuchBody(bodyId);
  const BodyDescription moving = *body;
  const ObjectDescription& was = scenario.object;
  const Pose pose = scenario.start * inverse(toReferencePoint(was, loaded));
  *body = {was.id, was.name, Mobility::Static, was.geometry, pose, was.colour, was.attributes};
  scenario.object = {moving.id, moving.name, moving.geometry, false, Vector3::Zero(), moving.colour, moving.attributes};
  chooseReferencePoint(scenario.object, geometryOf(moving.geometry, loaded));
  scenario.start = moving.pose * toReferencePoint(scenario.object, loaded);
  scenario.goal = GoalOut{};
  scenario.wayPoints.clear();
  const double radius = radiusAboutOrigin(objectMesh(scenario.object, geometryOf(moving.geometry, loaded)));
  scenario.workspace.extend(roomAbout(boxOfAll(loaded), radius));
  return Done{};
}

Box3 fittingWorkspace(const LoadedScenario& loaded) {
  Box3 workspace = roomAbout(boxOfAll(loaded), loaded.problem.world->objectRadius());
  if (const Pose* goal = std::get_if<Pose>(&loaded.problem.goal)) workspace.extend(goal->position);
  return workspace;
}

void takeAssembly(const Scenario& from, Scenario& to) {
  to.assets = from.assets;
  to.bodies = from.bodies;
  to.object = from.object;
  to.start = from.start;
  to.goal = from.goal;
  to.workspace = from.workspace;
  to.wayPoints = from.wayPoints;
  to.rules = from.rules;
  to.fits = from.fits;
  setSemanticEdits(semanticEditsOf(from), to);
}

}  // namespace glissade
