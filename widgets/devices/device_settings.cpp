#include "widgets/devices/device_settings.h"

#include <QUrl>

#include <limits>

namespace glissade {
namespace {

/// Prefix that tells apart both controllers of a headset, which have one name.
QString handOf(const HandInput& input) {
  switch (input.kind) {
    case InputKind::LeftController: return QStringLiteral("left-");
    case InputKind::RightController: return QStringLiteral("right-");
    default: return {};
  }
}

/// The device's name while it is connected, else its kind.
QString groupOf(const HandInput& input) {
  const std::string name = input.mailbox.reading().name;
  if (!name.empty()) {
    return handOf(input) + QString::fromLatin1(QUrl::toPercentEncoding(QString::fromStdString(name)));
  }
  switch (input.kind) {
    case InputKind::Keyboard: return QStringLiteral("Keyboard");
    case InputKind::Mouse6D: return QStringLiteral("any-6d-mouse");
    case InputKind::Gamepad: return QStringLiteral("any-gamepad");
    case InputKind::LeftController: return QStringLiteral("any-left-controller");
    case InputKind::RightController: return QStringLiteral("any-right-controller");
  }
  return {};
}

QString axisKey(const QString& group, std::size_t axis, const char* name) {
  return QStringLiteral("%1/axis-%2-%3").arg(group).arg(axis).arg(QLatin1String(name));
}

QString buttonKey(const QString& group, std::size_t button) {
  return QStringLiteral("%1/button-%2").arg(group).arg(button);
}

/// NaN if the text is no number: inRange() then takes the default.
double number(const QSettings& settings, const QString& key, double otherwise) {
  if (!settings.contains(key)) return otherwise;
  bool ok = false;
  const double value = settings.value(key).toDouble(&ok);
  return ok ? value : std::numeric_limits<double>::quiet_NaN();
}

/// The simple controller has one button, which is also its grip: closing the hand must trigger no action.
bool hasOneButton(const HandInput& input) { return input.mailbox.reading().name == "khr/simple_controller"; }

QString standardAction(const HandInput& input, std::size_t button) {
  const bool isLeft = input.kind == InputKind::LeftController;
  if (isLeft || input.kind == InputKind::RightController) {
    switch (static_cast<ControllerButton>(button)) {
      case ControllerButton::Menu: return isLeft ? QStringLiteral("run.stop") : QStringLiteral("run.start");
      case ControllerButton::Lower:
        return isLeft ? QStringLiteral("headset.section") : QStringLiteral("object.to-start");
      case ControllerButton::Upper: return QStringLiteral("path.play");
      case ControllerButton::Stick: return QStringLiteral("headset.panel-in-front");
      case ControllerButton::Trigger:
        if (hasOneButton(input)) return {};
        return isLeft ? QStringLiteral("headset.measure") : QStringLiteral("headset.select");
    }
  }
  if (button == 0) return QStringLiteral("operator.camera");
  return button == 1 ? QStringLiteral("view.fit") : QString();
}

}  // namespace

DeviceSettings::DeviceSettings()
    : settings_(QSettings::IniFormat, QSettings::UserScope, QStringLiteral("glissade"), QStringLiteral("devices")) {}

DeviceSettings::DeviceSettings(const QString& file) : settings_(file, QSettings::IniFormat) {}

DeviceShaping DeviceSettings::shaping(const HandInput& input) const {
  const QString group = groupOf(input);
  DeviceShaping shaping = standardShaping(input.kind);
  for (std::size_t i = 0; i < shaping.axes.size(); ++i) {
    AxisShaping& axis = shaping.axes[i];
    axis.source = settings_.value(axisKey(group, i, "source"), static_cast<uint>(axis.source)).toUInt();
    axis.deadZone = number(settings_, axisKey(group, i, "dead-zone"), axis.deadZone);
    axis.gain = number(settings_, axisKey(group, i, "gain"), axis.gain);
    axis.exponent = number(settings_, axisKey(group, i, "exponent"), axis.exponent);
    axis.inverted = settings_.value(axisKey(group, i, "inverted"), axis.inverted).toBool();
  }
  const auto flag = [&](const char* name) { return settings_.value(group + QLatin1String(name)).toBool(); };
  shaping.dominantAxis = flag("/dominant-axis");
  shaping.translationLocked = flag("/translation-locked");
  shaping.rotationLocked = flag("/rotation-locked");
  const std::string frame = settings_.value(group + QStringLiteral("/frame")).toString().toStdString();
  shaping.frame = kMotionFrameNames.find(frame).value_or(shaping.frame);
  shaping.linearSpeed = number(settings_, group + QStringLiteral("/linear-speed"), shaping.linearSpeed);
  shaping.angularSpeed = number(settings_, group + QStringLiteral("/angular-speed"), shaping.angularSpeed);
  return inRange(shaping);
}

void DeviceSettings::setShaping(const HandInput& input, const DeviceShaping& shaping) {
  const QString group = groupOf(input);
  for (std::size_t i = 0; i < shaping.axes.size(); ++i) {
    const AxisShaping& axis = shaping.axes[i];
    settings_.setValue(axisKey(group, i, "source"), static_cast<uint>(axis.source));
    settings_.setValue(axisKey(group, i, "dead-zone"), axis.deadZone);
    settings_.setValue(axisKey(group, i, "gain"), axis.gain);
    settings_.setValue(axisKey(group, i, "exponent"), axis.exponent);
    settings_.setValue(axisKey(group, i, "inverted"), axis.inverted);
  }
  settings_.setValue(group + QStringLiteral("/dominant-axis"), shaping.dominantAxis);
  settings_.setValue(group + QStringLiteral("/translation-locked"), shaping.translationLocked);
  settings_.setValue(group + QStringLiteral("/rotation-locked"), shaping.rotationLocked);
  settings_.setValue(group + QStringLiteral("/frame"), QLatin1String(kMotionFrameNames.of(shaping.frame)));
  settings_.setValue(group + QStringLiteral("/linear-speed"), shaping.linearSpeed);
  settings_.setValue(group + QStringLiteral("/angular-speed"), shaping.angularSpeed);
}

QString DeviceSettings::action(const HandInput& input, std::size_t button) const {
  return settings_.value(buttonKey(groupOf(input), button), standardAction(input, button)).toString();
}

void DeviceSettings::setAction(const HandInput& input, std::size_t button, const QString& actionId) {
  settings_.setValue(buttonKey(groupOf(input), button), actionId);
}

void DeviceSettings::reset(const HandInput& input) { settings_.remove(groupOf(input)); }

bool DeviceSettings::writable() const { return settings_.isWritable() && settings_.status() == QSettings::NoError; }

}  // namespace glissade
