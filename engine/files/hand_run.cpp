#include "engine/files/hand_run.h"

#include <algorithm>
#include <map>
#include <set>

#include "engine/files/assembly_edits.h"
#include "engine/files/object_geometry.h"
#include "engine/files/scenario_bodies.h"
#include "engine/fits/fit_edits.h"

namespace glissade {
namespace {

bool isIn(const std::vector<BodyId>& ids, const BodyId& id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

/// Checks that `ids` has either all rigid bodies of each body of the scenario, or none.
Outcome checkWhole(const std::vector<BodyId>& ids, const LoadedScenario& loaded) {
  const std::set<BodyId> named(ids.begin(), ids.end());
  std::map<BodyId, BodyId> partOf;  // one of the given rigid bodies, by the scenario's body
  for (const BodyId& id : ids) partOf.try_emplace(bodyIdOf(id), id);
  for (const RigidBody& each : rigidBodiesOf(loaded)) {
    const auto sister = partOf.find(bodyIdOf(each.id));
    if (sister == partOf.end() || named.count(each.id) > 0) continue;
    return Diagnostic{
        ErrorKind::Usage,
        loaded.file,
        {GLISSADE_TEXT("body '%1'"), {sister->first.text()}},
        {GLISSADE_TEXT("is several parts in one body of the scenario, of which '%1' cannot be moved alone"),
         {sister->second.text()}},
        GLISSADE_TEXT("Make a scenario that has each part as a body: New from parts does so with STEP files.")};
  }
  return Done{};
}

/// Ids of the scenario's bodies, without duplicates.
std::vector<BodyId> bodyIdsOf(const std::vector<BodyId>& rigidIds) {
  std::vector<BodyId> ids;
  for (const BodyId& rigid : rigidIds) {
    const BodyId id = bodyIdOf(rigid);
    if (!isIn(ids, id)) ids.push_back(id);
  }
  return ids;
}

/// The point about which these bodies turn in a product (see MovingObject), world frame.
Vector3 middleOf(const std::vector<RigidBody>& bodies) {
  if (bodies.size() == 1) {
    return bodies.front().X_WB * Vector3(boundingBox(*bodies.front().mesh, Pose::identity()).center());
  }
  Box3 box;
  for (const RigidBody& body : bodies) box.extend(boundingBox(*body.mesh, body.X_WB));
  return box.center();
}

/// Changes the reference point without moving the object. Motions between two configurations depend on the point about
/// which an object turns.
void turnAbout(const Vector3& point_W, const LoadedScenario& loaded, Scenario& scenario) {
  ObjectDescription& object = scenario.object;
  const Pose X_WG = scenario.start * Pose::translation(-referencePointOf(object, geometryOf(object, loaded)));
  object.centreOnVertexMean = false;
  object.referencePoint = inverse(X_WG) * point_W;
  scenario.start = X_WG * Pose::translation(object.referencePoint);
}

/// Marks the threads between moving and remaining bodies that the plan knows from joints, so that a run by hand
/// unscrews them as the plan does: the moving body is turned, the other one is held.
void markThreads(const std::vector<StepJoint>& joints, const std::vector<BodyId>& moving,
                 const std::vector<BodyId>& gone, FitSettings& fits) {
  for (const StepJoint& joint : joints) {
    if (joint.pitch == 0.0 || joint.turns <= 0.0) continue;
    const bool bodyMoves = isIn(moving, joint.body);
    for (const BodyId& other : joint.others) {
      const BodyId& held = bodyMoves ? other : joint.body;
      if (isIn(moving, other) == bodyMoves || isIn(gone, held)) continue;
      FitEdit& edit = editOf(joint.body, other, fits);
      if (edit.kind) continue;
      edit.kind = ContactKind::Thread;
      edit.pitch = joint.pitch;
      edit.turned = bodyMoves ? joint.body : other;
    }
  }
}

}  // namespace

Outcome prepareHandRun(const std::vector<BodyId>& moving, const std::vector<BodyId>& gone, const LoadedScenario& loaded,
                       const std::vector<StepJoint>& joints, Scenario& scenario) {
  for (const auto& ids : {moving, gone}) {
    if (const Outcome whole = checkWhole(ids, loaded); !whole) return whole;
  }
  std::vector<RigidBody> bodies;
  for (const RigidBody& body : rigidBodiesOf(loaded)) {
    if (isIn(moving, body.id)) bodies.push_back(body);
  }
  const std::vector<BodyId> chosen = bodyIdsOf(moving);
  if (!isObject(chosen, scenario)) {
    const Outcome marked = markMoving(chosen, loaded, scenario);
    if (!marked) return marked;
  }
  turnAbout(middleOf(bodies), loaded, scenario);
  markThreads(joints, moving, gone, scenario.fits);
  scenario.goal = GoalOut{};
  return editEach(bodyIdsOf(gone), removeBody, scenario);
}

DemandedMotion motionOfRun(const std::vector<RigidBody>& bodies, const std::vector<PathPoint>& path,
                           const PathProvenance& provenance) {
  const bool byHand = provenance.steered || isSteered(path) || provenance.planner.empty();
  DemandedMotion motion{{}, {}, byHand ? kByHand : provenance.planner};
  for (const RigidBody& body : bodies) motion.bodies.push_back(body.id.text());
  // Pose in the assembled product.
  const Pose X_WA = bodies.size() == 1 ? bodies.front().X_WB : Pose::translation(middleOf(bodies));
  const Pose X_OA = inverse(path.front().q) * X_WA;
  for (const PathPoint& point : path) {
    motion.path.push_back({point.q * X_OA, point.author, point.segmentAuthor});
    motion.path.back().q.orientation.normalize();
  }
  motion.path.front().q = X_WA;
  return motion;
}

}  // namespace glissade
