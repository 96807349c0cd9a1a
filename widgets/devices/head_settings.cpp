#include "widgets/devices/head_settings.h"

namespace glissade {
namespace {

constexpr int kLeastPort = 1;
constexpr int kMostPort = 65535;

const QLatin1String kPort("head/port");
const QLatin1String kFromAnywhere("head/from-anywhere");
const QLatin1String kDelay("head/delay-at-rest");

QString axisKey(std::size_t axis, const char* name) {
  return QStringLiteral("head/axis-%1-%2").arg(axis).arg(QLatin1String(name));
}

}  // namespace

HeadSettings::HeadSettings()
    : settings_(QSettings::IniFormat, QSettings::UserScope, QStringLiteral("glissade"), QStringLiteral("devices")) {}

HeadSettings::HeadSettings(const QString& file) : settings_(file, QSettings::IniFormat) {}

HeadPreferences HeadSettings::preferences() const {
  HeadPreferences preferences;
  HeadShaping& shaping = preferences.shaping;
  for (std::size_t i = 0; i < shaping.axes.size(); ++i) {
    shaping.axes[i].source = settings_.value(axisKey(i, "source"), shaping.axes[i].source).toInt();
    shaping.axes[i].inverted = settings_.value(axisKey(i, "inverted"), shaping.axes[i].inverted).toBool();
    shaping.rest[i] = settings_.value(axisKey(i, "rest"), shaping.rest[i]).toDouble();
  }
  shaping.restDelay = settings_.value(kDelay, shaping.restDelay).toDouble();
  shaping = inRange(shaping);
  const int port = settings_.value(kPort, preferences.port).toInt();
  if (port >= kLeastPort && port <= kMostPort) preferences.port = port;
  preferences.fromAnywhere = settings_.value(kFromAnywhere, preferences.fromAnywhere).toBool();
  return preferences;
}

void HeadSettings::save(const HeadPreferences& preferences) {
  const HeadShaping& shaping = preferences.shaping;
  for (std::size_t i = 0; i < shaping.axes.size(); ++i) {
    settings_.setValue(axisKey(i, "source"), shaping.axes[i].source);
    settings_.setValue(axisKey(i, "inverted"), shaping.axes[i].inverted);
    settings_.setValue(axisKey(i, "rest"), shaping.rest[i]);
  }
  settings_.setValue(kDelay, shaping.restDelay);
  settings_.setValue(kPort, preferences.port);
  settings_.setValue(kFromAnywhere, preferences.fromAnywhere);
}

bool HeadSettings::writable() const { return settings_.isWritable() && settings_.status() == QSettings::NoError; }

}  // namespace glissade
