#pragma once

#include <QSettings>
#include <QString>

#include "engine/operator/hand_inputs.h"

namespace glissade {

/// What a person has set, kept by the name of the device in a file of the user's configuration. What the
/// file does not hold, or holds out of range, is the standard.
class DeviceSettings {
 public:
  /// The user's file, in the place where the desktop keeps configurations.
  DeviceSettings();
  /// A file of one's own, for tests.
  explicit DeviceSettings(const QString& file);

  DeviceShaping shaping(const HandInput& input) const;
  void setShaping(const HandInput& input, const DeviceShaping& shaping);

  /// Id of the action that a button triggers; empty for none. Without a setting button 0 switches
  /// between object and camera, button 1 fits the view. The menu of a right controller starts a run then, that of a
  /// left one stops it.
  QString action(const HandInput& input, std::size_t button) const;
  void setAction(const HandInput& input, std::size_t button, const QString& actionId);

  /// Whether turning a device about the line of sight rolls the camera; of all devices, at first yes.
  bool cameraRolls() const { return settings_.value(QStringLiteral("camera-rolls"), true).toBool(); }
  void setCameraRolls(bool rolls) { settings_.setValue(QStringLiteral("camera-rolls"), rolls); }

  /// The left hand takes the object in a headset; at first the right one.
  bool leftHanded() const { return settings_.value(QStringLiteral("left-handed"), false).toBool(); }
  void setLeftHanded(bool left) { settings_.setValue(QStringLiteral("left-handed"), left); }

  /// The computer's share goes with the grip of a controller; at first yes.
  bool alphaFollowsGrip() const { return settings_.value(QStringLiteral("alpha-follows-grip"), true).toBool(); }
  void setAlphaFollowsGrip(bool follows) { settings_.setValue(QStringLiteral("alpha-follows-grip"), follows); }

  /// Shaping and buttons as if never set.
  void reset(const HandInput& input);

  /// False where the file cannot be written.
  bool writable() const;
  QString file() const { return settings_.fileName(); }

 private:
  QSettings settings_;
};

}  // namespace glissade
