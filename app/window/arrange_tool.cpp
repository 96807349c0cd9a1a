#include "app/window/arrange_tool.h"

#include <utility>

#include "app/window/scene_ray.h"

namespace glissade {
namespace {

struct Hit {
  AssemblyItem item;
  Vector3 p_W;
};

/// What the ray meets first of the items that are drawn and for which `accept` is true.
template <class Accept>
std::optional<Hit> hitOf(const LoadedScenario& scenario, const SceneView& view, const Ray& ray, Accept&& accept) {
  std::vector<RigidBody> bodies;
  std::vector<AssemblyItem> items;  // per body
  const auto add = [&](const RigidBody& body, const Pose& X_WB, const AssemblyItem& item) {
    if (!accept(item)) return;
    bodies.push_back(body);
    bodies.back().X_WB = X_WB;
    items.push_back(item);
  };
  for (const RigidBody& body : scenario.obstacles) {
    if (view.hiddenBodies().count(body.id) == 0) add(body, body.X_WB, {AssemblyItem::Kind::Body, bodyIdOf(body.id)});
  }
  if (view.layerVisible(SceneLayer::StartAndGoal)) {
    add(scenario.object, scenario.problem.start, {AssemblyItem::Kind::Start, {}});
    const Pose* goal = std::get_if<Pose>(&scenario.problem.goal);
    if (goal != nullptr) add(scenario.object, *goal, {AssemblyItem::Kind::Goal, {}});
  }
  const auto hit = pickBody(bodies, ray);
  if (!hit) return std::nullopt;
  return Hit{items[hit->body], ray.origin + hit->distance * ray.direction};
}

}  // namespace

ArrangeTool::ArrangeTool(const WorkbenchDocument& document, SceneWidget& scene, QObject* parent)
    : DragTool(scene, parent), document_(document) {
  connect(&document, &WorkbenchDocument::changed, this, [this](Changes what) {
    if (!inHand_ || !(what & (Change::Scenario | Change::Arrangement))) return;
    const bool stays =
        !(what & Change::Scenario) && poseOf(document_.scenario()->scenario, inHand_->item) == inHand_->before;
    if (stays) {
      draw(inHand_->drag.pose());
    } else {
      inHand_.reset();
    }
  });
}

void ArrangeTool::setOn(bool on) {
  on_ = on;
  if (inHand_) draw(inHand_->before);
  inHand_.reset();
  if (on) {
    scene_.widget()->setCursor(Qt::OpenHandCursor);
  } else {
    scene_.widget()->unsetCursor();
  }
}

bool ArrangeTool::grip(const QPointF& position) {
  const ScenarioPtr& scenario = document_.scenario();
  if (!on_ || !scenario) return false;
  const Ray ray = rayThrough(scene_, position);
  const auto grippable = [&](const AssemblyItem& item) { return selected_ && item == *selected_; };
  auto hit = hitOf(*scenario, scene_.view(), ray, grippable);
  if (!hit) hit = hitOf(*scenario, scene_.view(), ray, [](const AssemblyItem&) { return true; });
  if (!hit) return false;
  const Pose before = *poseOf(scenario->scenario, hit->item);
  inHand_ = InHand{hit->item, before, PoseDrag(before, hit->p_W, scene_.view().camera().R_WV())};
  scene_.widget()->setCursor(Qt::ClosedHandCursor);
  emit gripped(inHand_->item);
  return true;
}

void ArrangeTool::moveTo(const QPointF& position) {
  inHand_->drag.moveTo(rayThrough(scene_, position));
  draw(inHand_->drag.pose());
}

void ArrangeTool::turn(const QPointF& by) {
  inHand_->drag.turn(by.x(), by.y());
  draw(inHand_->drag.pose());
}

void ArrangeTool::draw(const Pose& X_WB) {
  SceneView& view = scene_.view();
  const InHand& hand = *inHand_;
  if (hand.item.kind == AssemblyItem::Kind::Start) view.placeStart(X_WB);
  if (hand.item.kind == AssemblyItem::Kind::Goal) view.placeGoal(X_WB);
  const std::vector<RigidBody>& obstacles = document_.scenario()->obstacles;
  for (std::size_t i = 0; i < obstacles.size() && hand.item.kind == AssemblyItem::Kind::Body; ++i) {
    const RigidBody& body = obstacles[i];
    if (bodyIdOf(body.id) == hand.item.bodyId) view.placeObstacle(i, X_WB * inverse(hand.before) * body.X_WB);
  }
  scene_.refresh();
}

void ArrangeTool::drop() {
  const InHand hand = *std::exchange(inHand_, std::nullopt);
  scene_.widget()->setCursor(Qt::OpenHandCursor);
  if (hand.drag.pose() != hand.before) emit dropped(hand.item, hand.drag.pose());
}

}  // namespace glissade
