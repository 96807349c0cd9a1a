#pragma once

#include <QComboBox>
#include <QLabel>
#include <QWidget>
#include <vector>

#include "widgets/bridge/session_bridge.h"
#include "widgets/commands/action_catalogue.h"
#include "widgets/panels/parameter_slider.h"
#include "widgets/panels/seed_box.h"

namespace glissade {

/// What steers a run: planner, who holds the object, the live parameters, seed, start and stop, and
/// who has the authority now.
class InteractionPanel final : public QWidget {
  Q_OBJECT

 public:
  InteractionPanel(const ActionCatalogue& actions, QWidget* parent = nullptr);

  void setScenario(const LoadedScenario& scenario);
  void setSnapshot(const SessionSnapshot& snapshot);
  void setDevice(const std::string& deviceId);
  /// What is shown is a replay: nothing can be steered, and it says so.
  void setReplayed(bool replayed);

 signals:
  void commanded(const glissade::Command& command);
  void deviceChosen(const QString& deviceId);

 private:
  QWidget* makeButtons(const ActionCatalogue& actions);
  void chooseTuning(ParameterId id, bool tuned);

  QComboBox* planner_;
  QComboBox* device_;
  SeedBox* seed_;
  QLabel* authority_;
  QLabel* replayed_;
  std::vector<ParameterSlider*> sliders_;
  int tuned_ = 0;  ///< what sets itself: bits of TunedSetting
};

}  // namespace glissade
