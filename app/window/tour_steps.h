#pragma once

#include <vector>

#include "app/window/workbench.h"

namespace glissade {

/// A step of the tour in the window.
struct TourStep {
  const char* title;   ///< English; translated in the context "Tour"
  const char* text;    ///< what to do and why; English, translated there, too
  const char* target;  ///< what is marked: the id of an action, or the object name of a widget
  /// What "Do it for me" carries out: lines of a script. "{report}" is a file in the folder of temporary files.
  std::vector<const char*> commands;
  /// Whether it is done; null: once the action was triggered or the commands were carried out.
  bool (*isDone)(const Workbench& bench);
};

/// A sample of the tour is open, and holds nothing but what the tour has made: it can be closed without a question.
bool isOfTour(const Workbench& bench);

/// Five with the teaching scenario, then six with parts that touch.
const std::vector<TourStep>& tourSteps();

}  // namespace glissade
