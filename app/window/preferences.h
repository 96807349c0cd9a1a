#pragma once

#include <QString>

#include "widgets/commands/length_text.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// Light, dark, or whichever of the two the desktop had when the program started.
enum class ThemeChoice { Desktop, Light, Dark };

/// A user's choices for all scenarios. WindowMemory keeps them.
struct Preferences {
  QString language;         ///< "en", "fr"; empty: that of the desktop
  double fontPoints = 9.0;  ///< of all texts of the window; small enough for three docks at 1280 x 720
  LengthUnit lengthUnit = LengthUnit::Fitting;  ///< Fitting: that of the product's file
  int autosaveSeconds = 3;                      ///< between two writings of what is not saved
  SceneColours colours = {};
  ThemeChoice theme = ThemeChoice::Desktop;
};

inline constexpr double kLeastFontPoints = 7.0;
inline constexpr double kMostFontPoints = 18.0;
inline constexpr int kLeastAutosaveSeconds = 1;
inline constexpr int kMostAutosaveSeconds = 60;

/// "en" or "fr": the language that is asked for, that of the preferences, or that of the desktop where the window has
/// it; English else.
QString languageOf(const QString& asked, const Preferences& preferences, const QString& desktop);

}  // namespace glissade
