#pragma once

#include <QWidget>

#include <set>
#include <vector>

#include "widgets/controls/parameter_slider.h"
#include "widgets/document/session_bridge.h"

namespace glissade {

/// Sliders of live parameters, one below the other, which follow a run.
class ParameterSliders final : public QWidget {
  Q_OBJECT

 public:
  explicit ParameterSliders(const std::vector<ParameterId>& ids, QWidget* parent = nullptr);

  void setScenario(const LoadedScenario& scenario);
  void setSnapshot(const SessionSnapshot& snapshot);
  /// Shows only these parameters.
  void showOnly(const std::set<ParameterId>& ids);
  const std::vector<ParameterSlider*>& all() const { return sliders_; }

 signals:
  void commanded(const glissade::Command& command);

 private:
  void chooseTuning(ParameterId id, bool tuned);

  std::vector<ParameterSlider*> sliders_;
  int tuned_ = 0;  ///< parameters that the tuner sets: bits of TunedSetting
};

}  // namespace glissade
