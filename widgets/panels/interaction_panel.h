#pragma once

#include <QComboBox>
#include <QLabel>
#include <QWidget>

#include "widgets/bridge/session_bridge.h"
#include "widgets/panels/pace_box.h"
#include "widgets/panels/parameter_sliders.h"
#include "widgets/panels/seed_box.h"

namespace glissade {

/// What steers a run: strategy, who holds the object, pace, seed, the live parameters that have an effect, and who has
/// the authority now.
class InteractionPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit InteractionPanel(QWidget* parent = nullptr);

  void setScenario(const LoadedScenario& scenario);
  void setSnapshot(const SessionSnapshot& snapshot);
  void setDevice(const std::string& deviceId);
  /// What is shown is a replay: nothing can be steered, and it says so.
  void setReplayed(bool replayed);

 signals:
  void commanded(const glissade::Command& command);
  void deviceChosen(const QString& deviceId);

 private:
  void fillStrategies();
  void addStrategies(bool main);
  /// The list has all strategies from now on.
  void showAdvanced();
  void chooseStrategy();
  /// The sentence about the strategy, and the sliders that it uses.
  void showUse();

  PlannerRegistry planners_ = makePlannerRegistry();
  QComboBox* planner_;
  int advancedRow_ = 0;  ///< of planner_: shows all strategies, and is then their title
  QLabel* about_;
  QComboBox* device_;
  PaceBox* pace_;
  SeedBox* seed_;
  QLabel* authorityTitle_;
  QLabel* authority_;
  QLabel* replayed_;
  ParameterSliders* sliders_;
  std::string shownStrategy_;  ///< of the last snapshot
  std::string shownUse_;       ///< strategy and device that showUse() was called for last
};

}  // namespace glissade
