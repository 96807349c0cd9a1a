#include "widgets/workbench/arranged_item.h"

#include "widgets/controls/body_id_text.h"

#include <QCoreApplication>

namespace glissade {

std::optional<ItemHit> itemAt(const LoadedScenario& scenario, const SceneView& view, const Ray& ray,
                              const std::optional<AssemblyItem>& only) {
  std::vector<RigidBody> bodies;
  std::vector<AssemblyItem> items;  // per body
  const auto add = [&](const RigidBody& body, const Pose& X_WB, const AssemblyItem& item) {
    if (only && item != *only) return;
    bodies.push_back(body);
    bodies.back().X_WB = X_WB;
    items.push_back(item);
  };
  for (const RigidBody& body : scenario.obstacles) {
    const bool drawn = view.layerVisible(SceneLayer::Bodies) && view.hiddenBodies().count(body.id) == 0;
    if (drawn) add(body, body.X_WB, {AssemblyItem::Kind::Body, bodyIdOf(body.id)});
  }
  if (view.layerVisible(SceneLayer::StartAndGoal)) {
    add(scenario.object, scenario.problem.start, {AssemblyItem::Kind::Start, {}});
    const Pose* goal = std::get_if<Pose>(&scenario.problem.goal);
    if (goal != nullptr) add(scenario.object, *goal, {AssemblyItem::Kind::Goal, {}});
  }
  const auto hit = pickBody(bodies, ray);
  if (!hit) return std::nullopt;
  return ItemHit{items[hit->body], bodies[hit->body], *hit, ray.origin + hit->distance * ray.direction};
}

void drawItemAt(const AssemblyItem& item, const Pose& X_WB, const LoadedScenario& scenario, SceneView& view) {
  if (item.kind == AssemblyItem::Kind::Start) view.placeStart(X_WB);
  if (item.kind == AssemblyItem::Kind::Goal) view.placeGoal(X_WB);
  if (item.kind != AssemblyItem::Kind::Body) return;
  const auto before = poseOf(scenario.scenario, item);
  if (!before) return;
  for (std::size_t i = 0; i < scenario.obstacles.size(); ++i) {
    const RigidBody& body = scenario.obstacles[i];
    if (bodyIdOf(body.id) == item.bodyId) view.placeObstacle(i, X_WB * inverse(*before) * body.X_WB);
  }
}

QString nameOf(const AssemblyItem& item, const LoadedScenario& scenario) {
  switch (item.kind) {
    case AssemblyItem::Kind::Start: return QCoreApplication::translate("Arranging", "the start");
    case AssemblyItem::Kind::Goal: return QCoreApplication::translate("Arranging", "the goal");
    case AssemblyItem::Kind::Body: break;
  }
  for (const RigidBody& body : scenario.obstacles) {
    if (body.id == item.bodyId) return QString::fromStdString(body.shown());
  }
  return toQString(item.bodyId);
}

}  // namespace glissade
