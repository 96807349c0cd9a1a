#pragma once

#include "widgets/run/assist_controller.h"
#include "widgets/run/difficulty_panel.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// Finds out why a run found no path, and shows it in a panel and in the scene.
class DifficultyController final : public QObject {
  Q_OBJECT

 public:
  explicit DifficultyController(const Workbench& bench);

  DifficultyPanel* panel() const { return panel_; }
  /// The difficulty that is shown; null: none.
  const DifficultyPtr& difficulty() const { return difficulty_; }

 signals:
  /// The action assist.go moved the camera.
  void cameraMoved();

 private:
  void followRun();
  void find();
  void show(const DifficultyPtr& difficulty, const HelpPlacesPtr& help);

  const Workbench& bench_;
  AssistController* assist_;  ///< shows the places to help, which the same work finds
  DifficultyPanel* panel_;
  DifficultyPtr difficulty_;
  HelpPlacesPtr help_;
};

}  // namespace glissade
