#pragma once

#include <vector>

#include "widgets/workbench/workbench.h"

namespace glissade {

/// A step of the tour in the window.
struct TourStep {
  const char* title;   ///< English; translated in the context "Tour"
  const char* text;    ///< the action and its reason; English, translated in the context "Tour"
  const char* target;  ///< the marked part: the id of an action, or the object name of a widget
  /// Lines of a script that "Do it for me" carries out. "{report}" is a file in the folder of temporary files.
  std::vector<const char*> commands;
  /// Whether the step is done; null: it is done when the action was triggered or the commands were carried out.
  bool (*isDone)(const Workbench& bench);
};

/// Whether a sample of the tour is open without other edits than the tour's, so that it can be closed without a
/// question.
bool isOfTour(const Workbench& bench);

/// The steps of the tour: five with the teaching scenario, then six with parts that touch.
const std::vector<TourStep>& tourSteps();

}  // namespace glissade
