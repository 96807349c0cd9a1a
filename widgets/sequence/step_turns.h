#pragma once

#include "widgets/controls/background_task.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

class SequenceController;

/// Finds how the product lies in each step of a plan that is complete, as its work instruction says.
class StepTurns final : public QObject {
  Q_OBJECT

 public:
  StepTurns(const Workbench& bench, SequenceController& sequence);

 private:
  void followPlan();

  const Workbench& bench_;
  SequenceController& sequence_;
  BackgroundTask task_;
};

}  // namespace glissade
