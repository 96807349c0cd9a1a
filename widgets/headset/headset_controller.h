#pragma once

#include <QLabel>
#include <QTimer>

#include "widgets/openxr/room_placement.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// Shows the scene in a headset: starts and stops it, describes its state in words, and keeps the place where the
/// person stands. While it is off, no thread runs.
class HeadsetController final : public QObject {
  Q_OBJECT

 public:
  explicit HeadsetController(const Workbench& bench);

  /// Puts the person where the camera of the view is, in the present scale.
  void standAt(const CameraPose& view);

  /// Text about the state of the headset; empty while it is off, and while it shows pictures without trouble.
  static QString textOf(const HeadsetStatus& status);
  /// Text about the cost of a picture.
  static QString textOf(const HeadsetFigures& figures);

 private:
  static QString troubleText(const HeadsetStatus& status);
  void disable();
  void setOn(bool on);
  void tick();
  void showStatus();
  void showFigures();
  RoomPlacement startPlace() const;
  void place(const RoomPlacement& room);
  void setBackground();

  const Workbench& bench_;
  QLabel* sign_;
  HeadsetStatus shown_;
  bool lacksControllers_ = false;    ///< is shown
  int ticksWithoutControllers_ = 0;  ///< ticks in which pictures were shown and no controller was known
  QTimer timer_;  ///< runs while the headset is on, because nothing announces a stall or that controllers are lacking
  Headset* headset_;  ///< the scene's headset; null: the scene can have none
};

}  // namespace glissade
