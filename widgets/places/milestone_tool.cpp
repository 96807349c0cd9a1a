#include "widgets/places/milestone_tool.h"

#include "engine/session/start_check.h"
#include "widgets/workbench/scene_ray.h"

namespace glissade {
namespace {

/// The region for the milestone of a border: the border and the two places that it joins.
SamplingRegion regionOf(const TopologicalMap& map, const Border& border) {
  const auto cellsOf = [&](int place) { return map.places[static_cast<std::size_t>(place)].cells; };
  return {map.grid, unionOf(border.cells, unionOf(cellsOf(border.placeA), cellsOf(border.placeB)))};
}

}  // namespace

MilestoneTool::MilestoneTool(WorkbenchDocument& document, SceneWidget& scene, QObject* parent)
    : DragTool(scene, parent), document_(document) {
  connect(&document, &WorkbenchDocument::changed, this, [this](Changes what) {
    if (what & (Change::Scenario | Change::Arrangement)) drag_.reset();
  });
}

void MilestoneTool::setPlan(const CoarsePlanPtr& plan) { plan_ = plan; }

CoarsePlanPtr MilestoneTool::shownPlan() const {
  if (!drag_) return plan_;
  auto shown = std::make_shared<CoarsePlan>(*gripped_);
  shown->steps[drag_->step()].to = drag_->pose();
  return shown;
}

bool MilestoneTool::grip(const QPointF& position) {
  if (!plan_ || !document_.knowledge() || !scene_.view().layerVisible(SceneLayer::Milestones)) return false;
  const Ray ray = rayThrough(scene_, position);
  const auto body = pickBody(document_.scenario()->obstacles, ray);
  drag_ = MilestoneDrag::grip(*plan_, document_.scenario()->object.mesh, ray, body ? body->distance : 1e9,
                              scene_.view().camera().R_WV());
  gripped_ = plan_;
  if (drag_) scene_.widget()->setCursor(Qt::ClosedHandCursor);
  return drag_.has_value();
}

void MilestoneTool::moveTo(const QPointF& position) {
  const TopologicalMap& map = gripped_->basis.environment->map;
  const int border = gripped_->steps[drag_->step()].border;
  drag_->moveTo(rayThrough(scene_, position), regionOf(map, map.borders[static_cast<std::size_t>(border)]));
  emit moved();
}

void MilestoneTool::turn(const QPointF& /*position*/, const QPointF& by) {
  drag_->turn(by.x(), by.y());
  emit moved();
}

void MilestoneTool::drop() {
  const Pose pose = drag_->pose();
  const TopologicalStep& step = gripped_->steps[drag_->step()];
  const Pose before = step.to;
  const int border = step.border;
  drag_.reset();
  scene_.widget()->unsetCursor();
  const Problem& problem = document_.scenario()->problem;
  if (const Outcome sound = checkMilestone(problem, *problem.world->makeQuery(), pose); !sound) {
    emit refused(sound.error());
  } else if (!(pose == before)) {
    document_.semantics().setMilestone(border, pose);
  }
  emit moved();
}

}  // namespace glissade
