#pragma once

#include <QSettings>

#include "engine/operator/head/head_tracking.h"

namespace glissade {

/// How the head is tracked.
struct HeadPreferences {
  HeadShaping shaping;
  int port = kOpentrackPort;
  bool fromAnywhere = false;  ///< from other machines, too

  friend bool operator==(const HeadPreferences&, const HeadPreferences&) = default;
};

/// What a person has set about the tracked head, kept in the file of the devices. What the file does not hold, or
/// holds out of range, is the standard.
class HeadSettings {
 public:
  /// The user's file, in the place where the desktop keeps configurations.
  HeadSettings();
  /// A file of one's own, for tests.
  explicit HeadSettings(const QString& file);

  HeadPreferences preferences() const;
  void save(const HeadPreferences& preferences);
  /// False where the file cannot be written.
  bool writable() const;
  QString file() const { return settings_.fileName(); }

 private:
  QSettings settings_;
};

}  // namespace glissade
