#pragma once

#include <QLabel>

#include "app/window/workbench.h"

namespace glissade {

/// Shows the scene in a headset: starts and stops it, says in words what it does, and keeps where the person stands. As
/// long as it is off there is no thread.
class HeadsetController final : public QObject {
  Q_OBJECT

 public:
  explicit HeadsetController(const Workbench& bench);

  /// What a person reads about the headset; empty while it shows pictures and while it is off.
  static QString textOf(const HeadsetStatus& status);
  /// What a picture costs.
  static QString textOf(const HeadsetFigures& figures);

 private:
  static QString troubleText(const HeadsetStatus& status);
  void disable();
  void setOn(bool on);
  void showStatus();
  void showFigures();
  void place();
  void setBackground();

  const Workbench& bench_;
  QLabel* sign_;
  HeadsetStatus shown_;
  Headset* headset_;  ///< of the scene; null: there can be none
};

}  // namespace glissade
