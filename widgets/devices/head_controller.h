#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QTimer>

#include "widgets/devices/head_dialog.h"
#include "widgets/devices/head_receiver.h"
#include "widgets/workbench/eye_place_keeper.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// Lets the view follow a tracked head. While it is off, there is no socket and no timer runs. Without a display it
/// listens to no tracker, and script commands give the readings.
class HeadController final : public QObject {
  Q_OBJECT

 public:
  HeadController(const Workbench& bench, EyePlaceKeeper& eyePlace);

  const HeadReceiver& receiver() const { return receiver_; }
  HeadState state() const;

 private:
  void addCommands();
  void setOn(bool on);
  bool listen();
  void change(const HeadPreferences& preferences);
  void take(const HeadReading& reading);
  /// Shows that no reading came for a while.
  void noticeSilence();
  void goBack();
  void show();
  void showDialog();
  bool isOn() const;
  double now() const;

  const Workbench& bench_;
  EyePlaceKeeper& eyePlace_;
  HeadSettings settings_;
  HeadPreferences preferences_;
  HeadTracking tracking_;
  HeadReceiver receiver_;
  QElapsedTimer clock_;
  double scriptTime_ = 0.0;  ///< time of scripts, seconds
  QTimer silence_;
  QTimer back_;
  QLabel* sign_;
  HeadDialog* dialog_ = nullptr;
};

}  // namespace glissade
