#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <array>
#include <memory>

#include "engine/operator/gamepad_reader.h"
#include "engine/operator/shaped_device.h"
#include "engine/operator/spacenav_reader.h"
#include "widgets/controls/action_catalogue.h"
#include "widgets/devices/device_settings.h"
#include "widgets/devices/grip_controller.h"
#include "widgets/document/session_bridge.h"
#include "widgets/scene3d/scene_widget.h"

class QLabel;
class QStatusBar;
class QToolButton;

namespace glissade {

class CalibrationDialog;

/// The person's devices in the window: reads them in real time, shows their target and whether they are connected, lets
/// their buttons trigger actions, and steers the camera while it is their target.
class DeviceController final : public QObject {
  Q_OBJECT

 public:
  DeviceController(SessionBridge& bridge, ActionCatalogue& actions, SceneWidget& scene, QWidget* window);
  ~DeviceController() override;

  /// Adds the steering target and the state of the devices.
  void addIndicators(QStatusBar& bar);
  /// Lockstep only: steers the camera for the time of `steps` planner steps.
  void advance(std::uint64_t steps);

 signals:
  /// A device moved the camera.
  void cameraMoved();

 private:
  void listen();
  /// Handles the changes of the mailboxes.
  void look();
  void lookAt(std::size_t which);
  void press(const HandInput& input, std::size_t button);
  void showStates();
  void showState(const HandInput& input, const QString& text, QLabel& label);
  std::optional<Diagnostic> problemOf(const HandInput& input) const;
  void showTarget();
  void setLeftHanded(bool left);
  void chooseNextFrame();
  void showFrame();
  void setTarget(SteeringTarget target);
  void showCalibration();
  void steer(double dt);

  /// The last reading of a device.
  struct Seen {
    bool connected = false;
    bool failed = false;
    std::string name;
    std::array<std::uint32_t, kInputButtons> presses{};
  };

  SessionBridge& bridge_;
  ActionCatalogue& actions_;
  SceneWidget& scene_;
  QWidget* window_;
  HandInputsPtr hand_;
  DeviceSettings settings_;
  GripController grip_;
  std::array<HandShaper, 3> shapers_;
  std::array<Seen, 5> seen_;
  QToolButton* target_ = nullptr;
  QToolButton* frame_ = nullptr;
  QLabel* mouse_ = nullptr;
  QLabel* gamepad_ = nullptr;
  CalibrationDialog* calibration_ = nullptr;
  QTimer cameraTimer_;
  QElapsedTimer cameraClock_;
  std::unique_ptr<SpacenavReader> mouseReader_;
  std::unique_ptr<GamepadReader> gamepadReader_;
};

}  // namespace glissade
