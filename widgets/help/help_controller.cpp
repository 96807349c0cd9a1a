#include "widgets/help/help_controller.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QMessageBox>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <QWhatsThis>
#include <QWidget>

#include "engine/base/version_text.h"
#include "widgets/controls/action_catalogue.h"
#include "widgets/devices/keyboard_steering.h"
#include "widgets/help/command_palette.h"
#include "widgets/help/shortcuts_dialog.h"
#include "widgets/help/whats_this.h"

namespace glissade {
namespace {

struct HelpPages {
  Q_DECLARE_TR_FUNCTIONS(HelpPages)
};

/// Shows a dialog that explains steering and lists all shortcuts.
void showShortcuts(const ActionCatalogue& actions, QWidget* parent) {
  auto* dialog = new QDialog(parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(HelpPages::tr("Keys and shortcuts"));
  dialog->resize(640, 640);
  auto* text = new QTextBrowser(dialog);
  text->setHtml(
      QStringLiteral("<h3>%1</h3><p>%2</p><table>%3</table><h3>%4</h3><table>%5</table>")
          .arg(HelpPages::tr("Steering"),
               HelpPages::tr(
                   "While the 3D view has the focus; directions are those of the view, until F chooses other axes."),
               KeyboardSteering::keyTable(), HelpPages::tr("Shortcuts"), actions.shortcutTable()));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  auto* layout = new QVBoxLayout(dialog);
  layout->addWidget(text);
  layout->addWidget(buttons);
  dialog->open();
}

/// Shows a dialog about the program.
void showAbout(QWidget* parent) {
  auto* box = new QMessageBox(
      QMessageBox::NoIcon, HelpPages::tr("About Glissade"),
      HelpPages::tr(
          "<h3>Glissade %1</h3><p>A workbench for virtual assembly: certified motions, found by a planner and a person "
          "together.</p><p>N. Blin, M. Taïx, P. Fillatreau, J.-Y. Fourquet, <i>Tuning Interaction in Motion Planning "
          "with Contact</i>, IEEE RO-MAN 2016.</p><p>S. Cailhol, P. Fillatreau, Y. Zhao, J.-Y. Fourquet, "
          "<i>Multi-layer path planning control for the simulation of manipulation tasks</i>, RCIM 57, 2019.</p>"
          "<p>BSD 3-Clause licence.</p>")
          .arg(QString::fromStdString(versionText())),
      QMessageBox::Ok, parent);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

}  // namespace

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
