#include "widgets/help/manual_controller.h"

#include <QApplication>
#include <QDir>
#include <QLocale>

#include "widgets/controls/menu_path.h"
#include "widgets/controls/window_language.h"
#include "widgets/devices/keyboard_steering.h"
#include "widgets/workbench/panel_docks.h"

namespace glissade {
namespace {

QString nativeKeys(const QAction* action) { return action->shortcut().toString(QKeySequence::NativeText); }

/// The folder of the manual, beside the programs of the build or in the installation.
QString manualFolder() {
  const QDir programs(QCoreApplication::applicationDirPath());
  const QString built = programs.absoluteFilePath(QStringLiteral("../manual"));
  return QDir::cleanPath(QDir(built).exists() ? built
                                              : programs.absoluteFilePath(QStringLiteral(GLISSADE_MANUAL_FOLDER)));
}

}  // namespace

ManualFacts manualFacts(const QMainWindow& window, const ActionCatalogue& actions) {
  ManualFacts facts;
  facts.language = windowLanguage() == Language::French ? QStringLiteral("fr") : QStringLiteral("en");
  for (const ActionSpec& spec : actions.specs()) {
    const QAction* action = actions[QLatin1String(spec.id)];
    facts.actions.push_back({action->objectName(), commandName(action->text()), menuPath(*action), nativeKeys(action),
                             action->statusTip()});
  }
  for (const NamedPanel& panel : panelsInOrder(window)) {
    const QAction* action = actions.find(panel.action);
    facts.panels.push_back({panel.id, panel.title, action != nullptr ? nativeKeys(action) : QString()});
  }
  facts.steeringRows = KeyboardSteering::keyTable();
  return facts;
}

ManualController::ManualController(const Workbench& bench) : QObject(&bench.window), bench_(bench) {
  bench.onAction("help.manual", this, [this] { open({}, {}); });
  bench.onAction("help.panel", this, [this] { openForPanel(); });
  addCommands();
}

void ManualController::open(const QString& page, const QString& anchor) {
  const ManualFacts facts = manualFacts(bench_.window, bench_.actions);
  auto pages = manualPages(facts);
  if (!pages) return bench_.messages.showError(tr("The manual cannot be shown"), pages.error());
  const bool first = browser_ == nullptr;
  if (first) browser_ = new ManualBrowser(manualFolder(), &bench_.window);
  browser_->setManual(facts.language, std::move(*pages));
  browser_->show();
  browser_->raise();
  browser_->activateWindow();
  if (!page.isEmpty() || first) browser_->openPage(page.isEmpty() ? manualPageNames().front() : page, anchor);
}

void ManualController::openForPanel() {
  const QWidget* panel = panelOf(QApplication::focusWidget());
  open(QStringLiteral("panels"), panel != nullptr ? QStringLiteral("panel-") + panel->objectName() : QString());
}

void ManualController::addCommands() {
  bench_.scripts.add("show-manual", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    const QStringList place = QString::fromStdString(words[0]).split(QLatin1Char('#'));
    if (!manualPageNames().contains(place[0])) return wrongCommand("the manual has no page '" + words[0] + "'");
    open(place[0], place.value(1));
    return Done{};
  });
  bench_.scripts.add("find-in-manual", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    if (browser_ == nullptr) return wrongCommand("the manual is not shown");
    if (browser_->find(QString::fromStdString(words[0]), true)) return Done{};
    return unmetExpectation("the manual does not have '" + words[0] + "'");
  });
  bench_.scripts.add("expect-manual", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    const std::string place = browser_ != nullptr ? browser_->place().toStdString() : "none";
    return place == words[0] ? Outcome(Done{}) : unmetExpectation("the manual shows " + place);
  });
}

}  // namespace glissade
