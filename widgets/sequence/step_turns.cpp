#include "widgets/sequence/step_turns.h"

#include "engine/documents/instruction/work_instruction.h"
#include "widgets/sequence/sequence_controller.h"

namespace glissade {

StepTurns::StepTurns(const Workbench& bench, SequenceController& sequence)
    : QObject(&sequence), bench_(bench), sequence_(sequence) {
  connect(&sequence, &SequenceController::planShown, this, &StepTurns::followPlan);
  connect(&task_, &BackgroundTask::failed, &bench.work, &WorkController::reportFailure);
}

void StepTurns::followPlan() {
  const ShownPlan& shown = sequence_.shown();
  if (!shown.plan || !shown.product || shown.growing || shown.plan->steps.empty()) {
    task_.cancel();
    return;
  }
  if (!shown.views.empty()) return;
  const auto work = [this, plan = shown.plan, product = shown.product,
                     words = windowPlanWords()](const WorkWatch& watch) -> BackgroundTask::Delivery {
    const WorkInstruction instruction = workInstruction(*plan, *product, {}, words, watch);
    if (watch.stop.stopRequested()) return [] {};
    return [this, plan, views = viewsOfSteps(instruction, *plan)] { sequence_.noteViews(plan, views); };
  };
  task_.start(GLISSADE_TEXT("looking how the product lies in each step"), work, bench_.work.isAtOnce());
}

}  // namespace glissade
