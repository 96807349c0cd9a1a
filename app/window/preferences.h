#pragma once

#include <QString>

namespace glissade {

/// A user's choices that no action has. WindowMemory keeps them.
struct Preferences {
  QString language;         ///< "en", "fr"; empty: that of the desktop
  double fontPoints = 9.0;  ///< of all texts of the window; small enough for three docks at 1280 x 720
};

inline constexpr double kLeastFontPoints = 7.0;
inline constexpr double kMostFontPoints = 18.0;

/// "en" or "fr": the language that is asked for, that of the preferences, or that of the desktop where the window has
/// it; English else.
QString languageOf(const QString& asked, const Preferences& preferences, const QString& desktop);

}  // namespace glissade
