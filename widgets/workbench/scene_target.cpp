#include "widgets/workbench/scene_target.h"

#include "engine/files/scenario_bodies.h"
#include "widgets/controls/body_id_text.h"
#include "widgets/workbench/scene_ray.h"

namespace glissade {
namespace {

/// Length of a ray in metres; no body is farther away.
constexpr double kEndOfRay = 1e9;

}  // namespace

SceneTarget targetAlong(const Workbench& bench, const Ray& ray) {
  const LoadedScenario& scenario = *bench.document.scenario();
  const SceneView& view = bench.scene.view();
  const std::vector<RigidBody> bodies = view.drawnObstacles();
  const auto body = pickBody(bodies, ray, {}, view.sections());
  const double farthest = body ? body->distance : kEndOfRay;
  SceneTarget target;
  if (view.showsSequence()) {
    target.isObject = body && isInObject(scenario, bodies[body->body].id);
  } else {
    RigidBody object = scenario.object;
    object.X_WB = view.objectPose();
    const auto hit = pickBody({object}, ray);
    target.isObject = view.layerVisible(SceneLayer::Object) && hit && hit->distance < farthest;
  }
  const SceneKnowledgePtr& knowledge = bench.document.knowledge();
  if (knowledge && view.layerVisible(SceneLayer::Places)) {
    target.place = pickPlace(knowledge->environment->map, ray, farthest);
  } else if (target.isObject && !view.showsSequence()) {
    target.body = toQString(scenario.objectBodies.front().id);
  } else if (body) {
    target.body = toQString(bodies[body->body].id);
  }
  return target;
}

SceneTarget targetAt(const Workbench& bench, const QPointF& position) {
  return targetAlong(bench, rayThrough(bench.scene, position));
}

}  // namespace glissade
