#pragma once

#include <QObject>

#include <functional>

#include "widgets/scene3d/scene_view.h"
#include "widgets/workbench/preferences.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

class WindowMemory;

/// Shows the dialog of preferences, and applies them at once.
class PreferencesController final : public QObject {
  Q_OBJECT

 public:
  /// Sets the seconds between two automatic writings.
  using SetAutosave = std::function<void(int seconds)>;

  PreferencesController(const Workbench& bench, SetAutosave setAutosave);

  /// Restores the remembered preferences, and remembers later choices. Scripts have no memory: their choices last until
  /// the window closes.
  void remember(WindowMemory& memory);

 private:
  void change();
  void apply(const Preferences& preferences);
  Theme themeOf(ThemeChoice choice) const;
  void takeTheme(bool dark);
  void showLengthUnit();

  const Workbench& bench_;
  SetAutosave setAutosave_;
  Theme desktopTheme_;  ///< the desktop's theme, read before the window set its own
  Preferences present_;
  WindowMemory* memory_ = nullptr;
};

}  // namespace glissade
