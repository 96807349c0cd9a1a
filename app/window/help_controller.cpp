#include "app/window/help_controller.h"

#include <QWhatsThis>

#include "app/window/command_palette.h"
#include "app/window/help_pages.h"
#include "app/window/shortcuts_dialog.h"
#include "app/window/whats_this.h"

namespace glissade {

HelpController::HelpController(const Workbench& bench) : QObject(&bench.window), bench_(bench) {
  explainWindow(bench.window);
  bench.onAction("help.shortcuts", this, [this] { showShortcuts(bench_.actions, &bench_.window); });
  bench.onAction("help.commands", this, [this] { findCommand(); });
  bench.onAction("help.change-shortcuts", this, [this] { changeShortcuts(); });
  bench.onAction("help.about", this, [this] { showAbout(&bench_.window); });
  bench.onAction("help.whats-this", this, [] { QWhatsThis::enterWhatsThisMode(); });
  bench.scripts.add("expect-explained", 0, [this](const ScriptCommands::Words&) -> Outcome {
    const QStringList names = unexplainedWidgets(bench_.window);
    if (names.isEmpty()) return Done{};
    return unmetExpectation("nothing explains " + names.join(QStringLiteral(", ")).toStdString());
  });
}

void HelpController::findCommand() {
  auto* palette = new CommandPalette(bench_.actions, &bench_.window);
  palette->setAttribute(Qt::WA_DeleteOnClose);
  palette->open();
  palette->field().setFocus();
}

void HelpController::changeShortcuts() {
  auto* dialog = new ShortcutsDialog(bench_.actions, &bench_.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    for (auto entry = dialog->shortcuts().begin(); entry != dialog->shortcuts().end(); ++entry) {
      bench_.actions.setShortcut(entry.key(), entry.value());
    }
  });
  dialog->open();
}

}  // namespace glissade
