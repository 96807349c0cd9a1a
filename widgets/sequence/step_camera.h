#pragma once

#include <memory>
#include <mutex>

#include "engine/sequence/step_view.h"
#include "widgets/controls/background_task.h"
#include "widgets/document/sequence_planner.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

class SequenceController;

/// Fits the view to the whole motion of a step's parts when the step is chosen, and to the motions of all steps when
/// they are played, as long as no person has moved the camera since the last fit. Turns the camera to a view of a
/// hidden part when a person chooses its step.
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
  void fitAll();
  void fit(const Box3& box);
  Box3 boxOfStep(std::size_t step) const;
  Box3 placeOf(std::size_t body) const;
  Box3 wayOf(const AssemblyStep& step) const;
  BodySet presentAt(std::size_t step) const;

  const Workbench& bench_;
  SequenceController& sequence_;
  std::shared_ptr<Views> views_;  ///< for the product of the last view; null: none
  BackgroundTask task_;
};

}  // namespace glissade
