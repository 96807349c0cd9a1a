#include "widgets/sequence/step_camera.h"

#include "engine/sequence/plan_bodies.h"
#include "engine/sequence/swept_box.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/sequence/sequence_controller.h"

namespace glissade {

StepCamera::StepCamera(const Workbench& bench, SequenceController& sequence)
    : QObject(&bench.window), bench_(bench), sequence_(sequence) {
  connect(sequence.panel(), &SequencePanel::stepChosen, this, &StepCamera::look);
  connect(bench.actions["sequence.play"], &QAction::toggled, this, [this](bool plays) {
    if (plays) fitAll();
  });
  connect(&task_, &BackgroundTask::failed, &bench.work, &WorkController::reportFailure);
}

/// The box of the step's bodies on their whole way, and of the bodies beside them.
Box3 StepCamera::boxOfStep(std::size_t step) const {
  const ShownPlan& shown = sequence_.shown();
  Box3 place;
  for (const std::size_t body : bodiesOf(shown.plan->steps[step], *shown.product)) place.extend(placeOf(body));
  Box3 box = wayOf(shown.plan->steps[step]);
  for (const std::size_t other : bodiesIn(presentAt(step))) {
    if (placeOf(other).intersects(place)) box.extend(placeOf(other));
  }
  return box;
}

Box3 StepCamera::placeOf(std::size_t body) const {
  const RigidBody& placed = sequence_.shown().product->bodies[body];
  return boundingBox(*placed.mesh, placed.X_WB);
}

Box3 StepCamera::wayOf(const AssemblyStep& step) const {
  Box3 box;
  for (const StepMotion& motion : step.motions) {
    for (const BodyId& id : motion.bodies()) {
      const RigidBody& body = sequence_.shown().product->body(id);
      const Pose X_PB = inverse(motion.path.front().q) * body.X_WB;
      std::vector<Pose> poses;
      for (const PathPoint& point : motion.path) poses.push_back(point.q * X_PB);
      box.extend(sweptBox(*body.mesh, poses));
    }
  }
  return box;
}

/// The bodies that are there when the step is carried out.
BodySet StepCamera::presentAt(std::size_t step) const {
  const ShownPlan& shown = sequence_.shown();
  BodySet present(shown.product->bodies.size(), true);
  for (std::size_t before = 0; before < step; ++before) {
    for (const std::size_t body : bodiesOf(shown.plan->steps[before], *shown.product)) present[body] = false;
  }
  return present;
}

/// Fits the view to the box, unless a person has moved the camera since the last fit.
void StepCamera::fit(const Box3& box) {
  CameraController& camera = bench_.scene.view().camera();
  if (!camera.isFitted() || sequence_.panel()->exploded() > 0.0) return;
  camera.fit(box);
  sequence_.showPanelsScene();
  emit cameraMoved();
}

void StepCamera::fitAll() {
  const ShownPlan& shown = sequence_.shown();
  if (!shown.plan || !shown.product) return;
  Box3 box;
  for (std::size_t body = 0; body < shown.product->bodies.size(); ++body) box.extend(placeOf(body));
  for (const AssemblyStep& step : shown.plan->steps) box.extend(wayOf(step));
  fit(box);
}

void StepCamera::look(int step) {
  fit(boxOfStep(static_cast<std::size_t>(step)));
  const ShownPlan shown = sequence_.shown();
  const Vector3 toEye = bench_.scene.view().camera().R_WV() * Vector3::UnitZ();
  const auto index = static_cast<std::size_t>(step);
  if (!views_ || views_->product != shown.product) views_ = std::make_shared<Views>(shown.product);
  const auto work = [this, shown, index, toEye, present = presentAt(index),
                     views = views_](const WorkWatch&) -> BackgroundTask::Delivery {
    const std::lock_guard lock(views->inUse);
    const auto better = views->view.betterEye(shown.plan->steps[index], present, toEye);
    return [this, better, index, plan = shown.plan] {
      if (!better || sequence_.shown().plan != plan) return;
      bench_.scene.view().camera().lookFrom(*better);
      fit(boxOfStep(index));
      bench_.scene.refresh();
      emit cameraMoved();
    };
  };
  task_.start(GLISSADE_TEXT("looking for a view of the step"), work, bench_.work.isAtOnce());
}

}  // namespace glissade
