#pragma once

#include <QSettings>

#include "engine/operator/head/head_tracking.h"

namespace glissade {

/// Settings of head tracking.
struct HeadPreferences {
  HeadShaping shaping;
  int port = kOpentrackPort;
  bool fromAnywhere = false;  ///< from other machines, too

  friend bool operator==(const HeadPreferences&, const HeadPreferences&) = default;
};

/// A person's settings of the tracked head, kept in the file of the devices. A value that is missing in the file, or
/// out of range, is the standard.
class HeadSettings {
 public:
  /// Reads the user's file, in the desktop's folder for configurations.
  HeadSettings();
  /// Reads another file, for tests.
  explicit HeadSettings(const QString& file);

  HeadPreferences preferences() const;
  void save(const HeadPreferences& preferences);
  /// False if the file cannot be written.
  bool writable() const;
  QString file() const { return settings_.fileName(); }

 private:
  QSettings settings_;
};

}  // namespace glissade
