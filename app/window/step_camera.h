#pragma once

#include "app/window/workbench.h"
#include "widgets/bridge/background_task.h"

namespace glissade {

class SequenceController;

/// Turns the camera to where the part of a step is seen, when a person chooses the step and the part is hidden. Where
/// it is seen, the camera stays.
class StepCamera final : public QObject {
  Q_OBJECT

 public:
  StepCamera(const Workbench& bench, SequenceController& sequence);

 signals:
  void cameraMoved();

 private:
  void look(int step);

  const Workbench& bench_;
  SequenceController& sequence_;
  BackgroundTask task_;
};

}  // namespace glissade
