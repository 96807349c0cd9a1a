#include "widgets/sequence/step_camera.h"

#include "engine/sequence/plan_bodies.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/sequence/sequence_controller.h"

namespace glissade {

StepCamera::StepCamera(const Workbench& bench, SequenceController& sequence)
    : QObject(&bench.window), bench_(bench), sequence_(sequence) {
  connect(sequence.panel(), &SequencePanel::stepChosen, this, &StepCamera::look);
  connect(&task_, &BackgroundTask::failed, &bench.work, &WorkController::reportFailure);
}

void StepCamera::look(int step) {
  const ShownPlan shown = sequence_.shown();
  const Vector3 toEye = bench_.scene.view().camera().R_WV() * Vector3::UnitZ();
  const auto index = static_cast<std::size_t>(step);
  if (!views_ || views_->product != shown.product) views_ = std::make_shared<Views>(shown.product);
  const auto work = [this, shown, index, toEye, views = views_](const WorkWatch&) -> BackgroundTask::Delivery {
    BodySet present(shown.product->bodies.size(), true);
    for (std::size_t before = 0; before < index; ++before) {
      for (const std::size_t body : bodiesOf(shown.plan->steps[before], *shown.product)) present[body] = false;
    }
    const std::lock_guard lock(views->inUse);
    const auto better = views->view.betterEye(shown.plan->steps[index], present, toEye);
    return [this, better, plan = shown.plan] {
      if (!better || sequence_.shown().plan != plan) return;
      bench_.scene.view().camera().lookFrom(*better);
      bench_.scene.refresh();
      emit cameraMoved();
    };
  };
  task_.start(GLISSADE_TEXT("looking for a view of the step"), work, bench_.work.isAtOnce());
}

}  // namespace glissade
