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

/// What a page about the head shows of it.
struct HeadState {
  bool on = false;       ///< the head is followed
  bool tracked = false;  ///< data come
  HeadReading reading{};
  HeadMotion motion;
  double delay = 0.0;  ///< seconds, as it is now
  std::uint64_t dropped = 0;
};

/// The calibration page of a head tracker: what it sends, live, and everything that turns it into the motion of a
/// head. A change counts at once.
class HeadDialog final : public QDialog {
  Q_OBJECT

 public:
  /// `state` is asked for while the page is seen.
  HeadDialog(const HeadPreferences& present, std::function<HeadState()> state, QWidget* parent);

  void setPreferences(const HeadPreferences& present);
  void refresh();
  /// The file of the settings cannot be written.
  void showTrouble(const QString& file);

 signals:
  void changed(const glissade::HeadPreferences& preferences);
  /// The person sits straight before the screen now.
  void restAsked();

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
