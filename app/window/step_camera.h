#pragma once

#include <memory>
#include <mutex>

#include "app/window/workbench.h"
#include "engine/sequence/step_view.h"
#include "widgets/bridge/background_task.h"
#include "widgets/bridge/sequence_planner.h"

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
  /// What all views of one product share: trees of its meshes.
  struct Views {
    explicit Views(ProductPtr of) : product(std::move(of)), view(*product) {}

    const ProductPtr product;
    std::mutex inUse;  ///< a step that was chosen before may still be looked at
    StepView view;     ///< guarded by inUse
  };

  void look(int step);

  const Workbench& bench_;
  SequenceController& sequence_;
  std::shared_ptr<Views> views_;  ///< of the product that was looked at last; null: none
  BackgroundTask task_;
};

}  // namespace glissade
