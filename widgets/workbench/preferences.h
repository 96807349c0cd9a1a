#pragma once

#include <QString>

#include <optional>

#include "widgets/controls/length_text.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// Light, dark, or the desktop's theme at the start of the program.
enum class ThemeChoice { Desktop, Light, Dark };

/// A user's choices for all scenarios. WindowMemory keeps them.
struct Preferences {
  QString language;         ///< "en", "fr"; empty: the desktop's
  double fontPoints = 9.0;  ///< size of all texts of the window; small enough for three docks at 1280 x 720
  std::optional<LengthUnit> lengthUnit{};  ///< none: the unit that suits the product
  int autosaveSeconds = 3;                 ///< seconds between two writings of unsaved edits
  SceneColours colours = {};
  ThemeChoice theme = ThemeChoice::Desktop;
};

inline constexpr double kLeastFontPoints = 7.0;
inline constexpr double kMostFontPoints = 18.0;
inline constexpr int kLeastAutosaveSeconds = 1;
inline constexpr int kMostAutosaveSeconds = 60;

/// "en" or "fr": the requested language, else that of the preferences, else the desktop's if the window has it, else
/// English.
QString languageOf(const QString& asked, const Preferences& preferences, const QString& desktop);

}  // namespace glissade
