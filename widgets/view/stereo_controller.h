#pragma once

#include <QTimer>

#include "widgets/workbench/eye_place_keeper.h"
#include "widgets/workbench/stereo_settings.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

class FullScreen;
class StereoDialog;
class StereoScreen;
class WindowMemory;

/// Stereo at the desk: the modes, the dialog about the modes and the screen, and the full screen.
class StereoController final : public QObject {
  Q_OBJECT

 public:
  StereoController(const Workbench& bench, EyePlaceKeeper& eyePlace);

  /// Restores the remembered settings, and remembers later changes.
  void remember(WindowMemory& memory);
  const StereoSettings& settings() const { return settings_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void connectActions();
  void change(const StereoSettings& settings);
  void apply();
  void askForQuadBuffer();
  void showDialog();
  void setFullScreen(bool on);
  void showAtTrueSize();
  /// The point of the scene in the plane of the screen.
  std::optional<Vector3> planePoint() const;
  void pickPlanePoint();

  const Workbench& bench_;
  EyePlaceKeeper& eyePlace_;
  StereoSettings settings_;
  StereoScreen* screen_;
  FullScreen* fullScreen_;
  StereoDialog* dialog_ = nullptr;
  WindowMemory* memory_ = nullptr;
  std::optional<Vector3> pointed_;  ///< point of the scene on which the pointer rested last
  QPointF pointer_;
  QTimer rest_;
};

}  // namespace glissade
