#pragma once

#include <QLabel>
#include <QWidget>

#include "engine/operator/device_registry.h"
#include "widgets/document/session_bridge.h"
#include "widgets/run/pace_box.h"
#include "widgets/run/parameter_sliders.h"
#include "widgets/run/research_box.h"
#include "widgets/run/seed_box.h"

namespace glissade {

/// The controls of a run: strategy, operator, pace, seed, the live parameters that have an effect, and the present
/// authority.
class InteractionPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit InteractionPanel(QWidget* parent = nullptr);

  /// The devices that are connected to it can be chosen; others are grey. Null: all can be chosen.
  void setHand(HandInputsPtr hand) { hand_ = std::move(hand); }
  void setScenario(const LoadedScenario& scenario);
  void setSnapshot(const SessionSnapshot& snapshot);
  void setDevice(const std::string& deviceId);
  /// Sets whether a replay is shown, which cannot be steered; the panel states this.
  void setReplayed(bool replayed);

 signals:
  void commanded(const glissade::Command& command);
  void deviceChosen(const QString& deviceId);

 private:
  void showMissingDevices();
  /// Shows the sentence about the strategy, and the sliders that it uses.
  void showUse();

  PlannerRegistry planners_ = makePlannerRegistry();
  DeviceRegistry devices_ = makeDeviceRegistry();
  HandInputsPtr hand_;
  ResearchBox* planner_;
  QLabel* about_;
  ResearchBox* device_;
  PaceBox* pace_;
  SeedBox* seed_;
  QLabel* authorityTitle_;
  QLabel* authority_;
  QLabel* replayed_;
  ParameterSliders* sliders_;
  std::string shownUse_;  ///< strategy and device of the last showUse()
};

}  // namespace glissade
