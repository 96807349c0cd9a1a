#include "app/window/preferences_controller.h"

#include <QApplication>

#include <utility>

#include "app/window/preferences_dialog.h"
#include "app/window/theme.h"
#include "app/window/window_memory.h"

namespace glissade {

PreferencesController::PreferencesController(const Workbench& bench, SetAutosave setAutosave)
    : QObject(&bench.window), bench_(bench), setAutosave_(std::move(setAutosave)) {
  bench.onAction("edit.preferences", this, [this] { change(); });
}

void PreferencesController::remember(WindowMemory& memory) {
  memory_ = &memory;
  apply(memory.preferences());
}

void PreferencesController::change() {
  present_.fontPoints = QApplication::font().pointSizeF();
  auto* dialog = new PreferencesDialog(bench_.actions, present_, &bench_.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    apply(dialog->preferences());
    if (memory_ == nullptr) return;
    memory_->savePreferences(present_);
    memory_->saveChoices(bench_.actions);
  });
  dialog->open();
}

void PreferencesController::apply(const Preferences& preferences) {
  present_ = preferences;
  setFontPoints(preferences.fontPoints);
  setAutosave_(preferences.autosaveSeconds);
  bench_.scene.view().setColours(preferences.colours);
  if (lengthUnit() != preferences.lengthUnit) {
    setLengthUnit(preferences.lengthUnit);
    announceLengthUnit();
  }
  bench_.scene.refresh();
}

}  // namespace glissade
