#include "app/window/preferences_controller.h"

#include <QApplication>

#include <utility>

#include "app/window/preferences_dialog.h"
#include "app/window/theme.h"
#include "engine/base/length_units.h"
#include "widgets/controls/dark_palette.h"
#include "widgets/workbench/window_memory.h"

namespace glissade {

PreferencesController::PreferencesController(const Workbench& bench, SetAutosave setAutosave)
    : QObject(&bench.window),
      bench_(bench),
      setAutosave_(std::move(setAutosave)),
      desktopTheme_(isDark(QApplication::palette()) ? Theme::Dark : Theme::Light) {
  bench.onAction("edit.preferences", this, [this] { change(); });
  // Before panels write lengths.
  connect(&bench.document, &WorkbenchDocument::changedForView, this, [this](Changes what) {
    if (what & (Change::Scenario | Change::Arrangement)) showLengthUnit();
  });
  connect(bench.actions["view.dark"], &QAction::toggled, this, &PreferencesController::takeTheme);
}

void PreferencesController::remember(WindowMemory& memory) {
  memory_ = &memory;
  apply(memory.preferences());
}

void PreferencesController::change() {
  present_.fontPoints = QApplication::font().pointSizeF();
  // A script or the command line may have changed the theme.
  const bool dark = bench_.actions["view.dark"]->isChecked();
  if ((themeOf(present_.theme) == Theme::Dark) != dark) present_.theme = dark ? ThemeChoice::Dark : ThemeChoice::Light;
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

Theme PreferencesController::themeOf(ThemeChoice choice) const {
  if (choice == ThemeChoice::Desktop) return desktopTheme_;
  return choice == ThemeChoice::Dark ? Theme::Dark : Theme::Light;
}

/// Remembers the light or dark theme that the action chose. The desktop's theme is chosen in the dialog.
void PreferencesController::takeTheme(bool dark) {
  if ((themeOf(present_.theme) == Theme::Dark) == dark) return;
  present_.theme = dark ? ThemeChoice::Dark : ThemeChoice::Light;
  if (memory_ != nullptr) memory_->savePreferences(present_);
}

void PreferencesController::apply(const Preferences& preferences) {
  present_ = preferences;
  setFontPoints(preferences.fontPoints);
  setAutosave_(preferences.autosaveSeconds);
  bench_.actions["view.dark"]->setChecked(themeOf(preferences.theme) == Theme::Dark);
  bench_.scene.view().setColours(preferences.colours);
  showLengthUnit();
  bench_.scene.refresh();
}

namespace {

/// The unit in which lengths of a scenario are shown if the user chose none.
LengthUnit unitOf(const LoadedScenario& scenario) {
  constexpr double kMillimetre = 1e-3;
  constexpr double kLargeWorkspace = 2.0;  // metres
  const double ofFile = scenario.product.lengthUnit();
  const LengthUnit unit = lengthUnitFor(ofFile);
  if (unit == LengthUnit::Inches || ofFile == kMillimetre) return unit;
  const bool isLarge = scenario.problem.bounds.sizes().maxCoeff() >= kLargeWorkspace;
  return isLarge ? LengthUnit::Metres : LengthUnit::Millimetres;
}

}  // namespace

/// Shows lengths in the unit that suits the scenario if no unit was chosen.
void PreferencesController::showLengthUnit() {
  setPreferredLengthUnit(present_.lengthUnit);
  const ScenarioPtr scenario = bench_.document.scenario();
  const LengthUnit unit = present_.lengthUnit ? *present_.lengthUnit
                          : scenario          ? unitOf(*scenario)
                                              : LengthUnit::Millimetres;
  if (unit == lengthUnit()) return;
  setLengthUnit(unit);
  announceLengthUnit();
}

}  // namespace glissade
