#pragma once

#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QToolBar>

#include "widgets/commands/action_catalogue.h"

namespace glissade {

/// The recorder's front: step, play, speed, the time slider, and what is being seen. Clearly marked,
/// so that nobody takes a replay for a run.
class ReplayBar final : public QToolBar {
  Q_OBJECT

 public:
  explicit ReplayBar(const ActionCatalogue& actions, QWidget* parent = nullptr);

  /// Where the replay is shown, of how many steps, and in the run's own time.
  void setPlace(std::uint64_t step, std::uint64_t steps, double seconds);
  /// What there is to say about the whole replay, in two words; `alarming`: it is not as recorded.
  void setVerdict(const QString& verdict, const QString& tip, bool alarming);
  /// Times real time; 0: as fast as it can be seen.
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
