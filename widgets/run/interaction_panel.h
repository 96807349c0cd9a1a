#pragma once

#include <QComboBox>
#include <QLabel>
#include <QWidget>

#include "widgets/document/session_bridge.h"
#include "widgets/run/pace_box.h"
#include "widgets/run/parameter_sliders.h"
#include "widgets/run/seed_box.h"

namespace glissade {

/// The controls of a run: strategy, operator, pace, seed, the live parameters that have an effect, and the present
/// authority.
class InteractionPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit InteractionPanel(QWidget* parent = nullptr);

  void setScenario(const LoadedScenario& scenario);
  void setSnapshot(const SessionSnapshot& snapshot);
  void setDevice(const std::string& deviceId);
  /// Sets whether a replay is shown, which cannot be steered; the panel states this.
  void setReplayed(bool replayed);

 signals:
  void commanded(const glissade::Command& command);
  void deviceChosen(const QString& deviceId);

 private:
  void fillStrategies();
  void addStrategies(bool main);
  /// Lists all strategies from now on.
  void showAdvanced();
  void chooseStrategy();
  /// Shows the sentence about the strategy, and the sliders that it uses.
  void showUse();

  PlannerRegistry planners_ = makePlannerRegistry();
  QComboBox* planner_;
  int advancedRow_ = 0;  ///< row of planner_ that shows all strategies, and is their title then
  QLabel* about_;
  QComboBox* device_;
  PaceBox* pace_;
  SeedBox* seed_;
  QLabel* authorityTitle_;
  QLabel* authority_;
  QLabel* replayed_;
  ParameterSliders* sliders_;
  std::string shownStrategy_;  ///< strategy of the last snapshot
  std::string shownUse_;       ///< strategy and device of the last showUse()
};

}  // namespace glissade
