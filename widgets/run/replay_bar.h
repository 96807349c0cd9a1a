#pragma once

#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QToolBar>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The controls of a replay: step, play, speed, and the time slider. The bar is clearly marked, so that nobody takes a
/// replay for a run.
class ReplayBar final : public QToolBar {
  Q_OBJECT

 public:
  explicit ReplayBar(const ActionCatalogue& actions, QWidget* parent = nullptr);

  /// Shows the step of the replay, the number of steps, and the run's own time.
  void setPlace(std::uint64_t step, std::uint64_t steps, double seconds);
  /// Shows a verdict on the whole replay, in two words; `alarming`: the replay differs from the recording.
  void setVerdict(const QString& verdict, const QString& tip, bool alarming);
  /// Multiple of real time; 0: as fast as the steps can be seen.
  double speed() const;

 signals:
  void stepChosen(quint64 step);

 private:
  QComboBox* speed_;
  QSlider* slider_;
  QLabel* place_;
  QLabel* verdict_;
  std::uint64_t steps_ = 0;
};

}  // namespace glissade
