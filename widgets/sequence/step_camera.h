#pragma once

#include <memory>
#include <mutex>

#include "engine/sequence/step_view.h"
#include "widgets/controls/background_task.h"
#include "widgets/document/sequence_planner.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

class SequenceController;

/// Turns the camera to a view of a step's part when a person chooses the step and the part is hidden. If the part is
/// visible, the camera stays.
class StepCamera final : public QObject {
  Q_OBJECT

 public:
  StepCamera(const Workbench& bench, SequenceController& sequence);

 signals:
  void cameraMoved();

 private:
  /// Data that all views of one product share: trees of its meshes.
  struct Views {
    explicit Views(ProductPtr of) : product(std::move(of)), view(*product) {}

    const ProductPtr product;
    std::mutex inUse;  ///< a view of an earlier step may still be computed
    StepView view;     ///< guarded by inUse
  };

  void look(int step);

  const Workbench& bench_;
  SequenceController& sequence_;
  std::shared_ptr<Views> views_;  ///< for the product of the last view; null: none
  BackgroundTask task_;
};

}  // namespace glissade
