#pragma once

#include <QSettings>
#include <QString>

#include "engine/operator/hand_inputs.h"

namespace glissade {

/// A person's settings, kept by the name of the device in a file of the user's configuration. A value that is missing
/// in the file, or out of range, is the standard.
class DeviceSettings {
 public:
  /// Reads the user's file, in the desktop's folder for configurations.
  DeviceSettings();
  /// Reads another file, for tests.
  explicit DeviceSettings(const QString& file);

  DeviceShaping shaping(const HandInput& input) const;
  void setShaping(const HandInput& input, const DeviceShaping& shaping);

  /// Id of the action that a button triggers; empty for none. Without a setting, button 0 of a device switches between
  /// object and camera and button 1 fits the view; the buttons of controllers have standard actions of their own.
  QString action(const HandInput& input, std::size_t button) const;
  void setAction(const HandInput& input, std::size_t button, const QString& actionId);

  /// Whether turning a device about the line of sight rolls the camera, for all devices; yes by default.
  bool cameraRolls() const { return settings_.value(QStringLiteral("camera-rolls"), true).toBool(); }
  void setCameraRolls(bool rolls) { settings_.setValue(QStringLiteral("camera-rolls"), rolls); }

  /// Whether the left hand takes the object in a headset; no by default.
  bool leftHanded() const { return settings_.value(QStringLiteral("left-handed"), false).toBool(); }
  void setLeftHanded(bool left) { settings_.setValue(QStringLiteral("left-handed"), left); }

  /// Whether the grip of a controller sets the computer's share; yes by default.
  bool alphaFollowsGrip() const { return settings_.value(QStringLiteral("alpha-follows-grip"), true).toBool(); }
  void setAlphaFollowsGrip(bool follows) { settings_.setValue(QStringLiteral("alpha-follows-grip"), follows); }

  /// Resets shaping and buttons to the standard.
  void reset(const HandInput& input);

  /// False if the file cannot be written.
  bool writable() const;
  QString file() const { return settings_.fileName(); }

 private:
  QSettings settings_;
};

}  // namespace glissade
