#pragma once

#include <QObject>

#include <functional>

#include "app/window/preferences.h"
#include "app/window/workbench.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {

class WindowMemory;

/// Asks for the preferences, and lets the window follow them at once.
class PreferencesController final : public QObject {
  Q_OBJECT

 public:
  /// Sets the seconds between two automatic writings.
  using SetAutosave = std::function<void(int seconds)>;

  PreferencesController(const Workbench& bench, SetAutosave setAutosave);

  /// Takes what is remembered; from now on it is kept there. Scripts have no memory: what they choose holds until the
  /// window closes.
  void remember(WindowMemory& memory);

 private:
  void change();
  void apply(const Preferences& preferences);
  Theme themeOf(ThemeChoice choice) const;
  void takeTheme(bool dark);
  void showLengthUnit();

  const Workbench& bench_;
  SetAutosave setAutosave_;
  Theme desktopTheme_;  ///< before the window gave the program its own
  Preferences present_;
  WindowMemory* memory_ = nullptr;
};

}  // namespace glissade
