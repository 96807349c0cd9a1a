#pragma once

#include <QObject>

#include "widgets/bridge/session_bridge.h"
#include "widgets/commands/action_catalogue.h"
#include "widgets/panels/difficulty_panel.h"
#include "widgets/scene3d/scene_widget.h"

namespace glissade {

class WorkController;

/// Looks into why a run found no path, and shows it in a panel and in the scene. Part of the main window.
class DifficultyController final : public QObject {
  Q_OBJECT

 public:
  DifficultyController(const ActionCatalogue& actions, SceneWidget& scene, WorkController& work, QWidget* window);

  DifficultyPanel* panel() const { return panel_; }
  void open(const ScenarioPtr& scenario);
  /// `live`: not of a replay.
  void showSnapshot(const SnapshotPtr& snapshot, bool live);
  /// What is shown; null: nothing.
  const DifficultyPtr& difficulty() const { return difficulty_; }
  const ScenarioPtr& scenario() const { return scenario_; }

 signals:
  /// There is something to see in the panel.
  void found();

 private:
  void find();
  void show(const DifficultyPtr& difficulty);

  const ActionCatalogue& actions_;
  SceneWidget& scene_;
  WorkController& work_;
  DifficultyPanel* panel_;
  ScenarioPtr scenario_;
  SnapshotPtr snapshot_;
  DifficultyPtr difficulty_;
};

}  // namespace glissade
