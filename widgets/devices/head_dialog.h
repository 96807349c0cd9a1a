#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QGridLayout>
#include <QLabel>
#include <QSpinBox>
#include <QTimer>

#include <array>
#include <functional>

#include "widgets/devices/head_settings.h"

namespace glissade {

/// State of the head tracker that the calibration page shows.
struct HeadState {
  bool on = false;       ///< the head is followed
  bool tracked = false;  ///< data arrive
  HeadReading reading{};
  HeadMotion motion;
  double delay = 0.0;  ///< present delay, seconds
  std::uint64_t dropped = 0;
};

/// The calibration page of a head tracker: its live data, and the settings that turn them into the motion of a head. A
/// change takes effect at once and is kept.
class HeadDialog final : public QDialog {
  Q_OBJECT

 public:
  /// `state` is called while the page is visible.
  HeadDialog(const HeadPreferences& present, std::function<HeadState()> state, QWidget* parent);

  void setPreferences(const HeadPreferences& present);
  void refresh();
  /// Says that the file of the settings cannot be written.
  void showTrouble(const QString& file);

 signals:
  void changed(const glissade::HeadPreferences& preferences);
  /// The person asks to take the present pose of the head as the rest pose.
  void restRequested();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  struct Row {
    QComboBox* source;
    QCheckBox* inverted;
    QLabel* sent;
    QLabel* head;
  };

  QGridLayout* makeAxes();
  QLayout* makeSocket();
  QLayout* makeDelay();
  HeadPreferences preferences() const;
  void announce();

  std::function<HeadState()> state_;
  HeadReading rest_{};
  std::array<Row, 6> rows_{};
  QSpinBox* port_;
  QCheckBox* fromAnywhere_;
  QSpinBox* delay_;
  QLabel* delayNow_;
  QLabel* stateText_;
  QLabel* trouble_;
  QTimer timer_;
};

}  // namespace glissade
