#include "engine/files/assembly_edits.h"

#include <algorithm>

#include "engine/files/object_geometry.h"
#include "engine/files/part_files.h"
#include "engine/files/scenario_bodies.h"
#include "engine/files/scenario_product.h"
#include "engine/import/geometry_loader.h"

namespace glissade {
namespace {

Diagnostic refusal(const Location& location, const Message& reason, const Message& advice) {
  return {ErrorKind::Usage, "", location, reason, advice};
}

Location placeOf(const BodyId& bodyId) { return {GLISSADE_TEXT("body '%1'"), {bodyId.text()}}; }

Diagnostic noSuchBody(const BodyId& id) {
  return refusal(placeOf(id), GLISSADE_TEXT("there is no such body"),
                 GLISSADE_TEXT("Choose one of the panel Product."));
}

std::vector<BodyDescription>::iterator findBody(const BodyId& id, Scenario& scenario) {
  return std::find_if(scenario.bodies.begin(), scenario.bodies.end(),
                      [&](const BodyDescription& body) { return body.id == id; });
}

bool uses(const Geometry& geometry, const Asset& asset) {
  const std::string* id = assetOf(geometry);
  return id != nullptr && *id == asset.id;
}

void dropUnusedAssets(Scenario& scenario) {
  const std::vector<const BodyDescription*> bodies = allBodiesOf(scenario);
  std::erase_if(scenario.assets, [&](const Asset& asset) {
    return std::none_of(bodies.begin(), bodies.end(),
                        [&](const BodyDescription* body) { return uses(body->geometry, asset); });
  });
}

void dropFitsOf(const BodyId& bodyId, Scenario& scenario) {
  std::erase_if(scenario.fits.pairs,
                [&](const FitEdit& edit) { return bodyIdOf(edit.a) == bodyId || bodyIdOf(edit.b) == bodyId; });
}

void dropJointsOf(const BodyId& bodyId, Scenario& scenario) {
  const auto isOfBody = [&](const BodyId& id) { return bodyIdOf(id) == bodyId; };
  std::erase_if(scenario.joints, [&](const JointEdit& edit) {
    return isOfBody(edit.key.body) || std::any_of(edit.key.others.begin(), edit.key.others.end(), isOfBody);
  });
  for (JointEdit& edit : scenario.joints) std::erase_if(edit.clamped, isOfBody);
}

/// The transformation from the frame of an object's geometry to its reference point.
Pose toReferencePoint(const ObjectDescription& object, const ObjectGeometry& geometry) {
  return Pose::translation(referencePointOf(object, geometry));
}

/// The object's bodies at the start, as bodies of the product.
std::vector<BodyDescription> placedBodiesOf(const ObjectDescription& object, const LoadedScenario& loaded,
                                            const Pose& start) {
  const Pose X_WG = start * inverse(toReferencePoint(object, geometryOf(object, loaded)));
  std::vector<BodyDescription> bodies = object.bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].pose = i == 0 ? X_WG : X_WG * poseInObject(object, i);
  return bodies;
}

/// Takes the body from the list; nothing where it is not in it.
std::optional<BodyDescription> taken(const BodyId& id, std::vector<BodyDescription>& from) {
  const auto body = std::find_if(from.begin(), from.end(), [&](const BodyDescription& each) { return each.id == id; });
  if (body == from.end()) return std::nullopt;
  BodyDescription found = std::move(*body);
  from.erase(body);
  return found;
}

ObjectDescription objectOf(std::vector<BodyDescription> placed) {
  ObjectDescription object;
  object.bodies = std::move(placed);
  const Pose X_GW = inverse(object.first().pose);
  for (std::size_t i = 1; i < object.bodies.size(); ++i) object.bodies[i].pose = X_GW * object.bodies[i].pose;
  object.first().pose = Pose::identity();
  return object;
}

/// Bounding box of the bodies and of the object at its start.
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
  if (!isValid(X_WB))
    return refusal("", GLISSADE_TEXT("this is not a position in space"), GLISSADE_TEXT("Give finite numbers."));
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

Outcome removeBody(const BodyId& bodyId, Scenario& scenario) {
  if (!taken(bodyId, scenario.bodies)) return noSuchBody(bodyId);
  dropFitsOf(bodyId, scenario);
  dropJointsOf(bodyId, scenario);
  dropUnknownNodes(scenario);
  dropUnusedAssets(scenario);
  return Done{};
}

Outcome renameBody(const BodyId& bodyId, const std::string& name, Scenario& scenario) {
  if (name.empty() || name.find('/') != std::string::npos)
    return refusal(placeOf(bodyId), {GLISSADE_TEXT("cannot have the name '%1'"), {name}},
                   GLISSADE_TEXT("Give a name without '/'."));
  for (std::vector<BodyDescription>* bodies : {&scenario.object.bodies, &scenario.bodies}) {
    for (BodyDescription& body : *bodies) {
      if (body.id != bodyId) continue;
      const std::size_t assemblies = body.name.rfind('/');
      body.name = (assemblies == std::string::npos ? "" : body.name.substr(0, assemblies + 1)) + name;
      return Done{};
    }
  }
  return noSuchBody(bodyId);
}

Outcome leaveOut(const BodyId& bodyId, Scenario& scenario) {
  for (const BodyDescription& moving : scenario.object.bodies) {
    if (moving.id == bodyId)
      return refusal(placeOf(bodyId), GLISSADE_TEXT("is the moving part"),
                     GLISSADE_TEXT("Choose another object first."));
  }
  auto body = taken(bodyId, scenario.bodies);
  if (!body) return noSuchBody(bodyId);
  dropFitsOf(bodyId, scenario);
  dropJointsOf(bodyId, scenario);
  scenario.leftOut.push_back(std::move(*body));
  return Done{};
}

Outcome putBack(const BodyId& bodyId, Scenario& scenario) {
  auto body = taken(bodyId, scenario.leftOut);
  if (!body) return noSuchBody(bodyId);
  scenario.bodies.push_back(std::move(*body));
  return Done{};
}

Outcome swapEnds(Scenario& scenario) {
  Pose* goal = std::get_if<Pose>(&scenario.goal);
  if (goal == nullptr)
    return refusal(GLISSADE_TEXT("goal"), GLISSADE_TEXT("the goal is \"removed\", which has no position"),
                   GLISSADE_TEXT("Give the goal a position first."));
  std::swap(scenario.start, *goal);
  return Done{};
}

bool isObject(const std::vector<BodyId>& bodyIds, const Scenario& scenario) {
  const std::vector<BodyDescription>& bodies = scenario.object.bodies;
  return bodyIds.size() == bodies.size() && std::all_of(bodies.begin(), bodies.end(), [&](const BodyDescription& body) {
           return std::find(bodyIds.begin(), bodyIds.end(), body.id) != bodyIds.end();
         });
}

Outcome markMoving(const std::vector<BodyId>& bodyIds, const LoadedScenario& loaded, Scenario& scenario) {
  if (bodyIds.empty())
    return refusal("", GLISSADE_TEXT("no body is selected"), GLISSADE_TEXT("Select the moving part."));
  if (isObject(bodyIds, scenario))
    return refusal("", GLISSADE_TEXT("this is the object already"), GLISSADE_TEXT("Choose other bodies."));
  const std::vector<BodyDescription> before = placedBodiesOf(scenario.object, loaded, scenario.start);
  std::vector<BodyDescription> others = scenario.bodies;
  const auto first = std::find_if(others.begin(), others.end(),
                                  [&](const BodyDescription& body) { return body.id == bodyIds.front(); });
  // The bodies that stop moving are inserted where the bodies that begin to move were.
  others.insert(first, before.begin(), before.end());
  std::vector<BodyDescription> moving;
  for (const BodyId& id : bodyIds) {
    auto body = taken(id, others);
    if (!body) return noSuchBody(id);
    moving.push_back(std::move(*body));
  }
  const Pose X_WG = moving.front().pose;
  scenario.bodies = std::move(others);
  scenario.object = objectOf(std::move(moving));
  const ObjectGeometry geometry = geometryOf(scenario.object, loaded);
  chooseReferencePoint(scenario.object, geometry);
  scenario.start = X_WG * toReferencePoint(scenario.object, geometry);
  scenario.goal = GoalOut{};
  scenario.wayPoints.clear();
  const double radius = radiusAboutOrigin(objectMesh(scenario.object, geometry));
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
  to.leftOut = from.leftOut;
  to.nodes = from.nodes;
  to.start = from.start;
  to.goal = from.goal;
  to.workspace = from.workspace;
  to.wayPoints = from.wayPoints;
  to.rules = from.rules;
  to.fits = from.fits;
  to.joints = from.joints;
  setSemanticEdits(semanticEditsOf(from), to);
}

}  // namespace glissade
