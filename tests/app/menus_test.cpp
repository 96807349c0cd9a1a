// The menus of the window, in English and in French.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QDirIterator>
#include <QFile>
#include <QLabel>
#include <QMenuBar>
#include <QRegularExpression>
#include <set>
#include <string>
#include <tuple>

#include "app/window/menu_table.h"
#include "tests/app/whole_window.h"
#include "widgets/controls/menu_mnemonics.h"
#include "widgets/controls/menu_path.h"
#include "widgets/help/manual_controller.h"
#include "widgets/help/manual_pages.h"

namespace glissade {
namespace {

constexpr int kMostEntries = 18;
/// Height of a screen of 1920 x 1080 pixels at 200 %.
constexpr int kLeastScreenHeight = 540;

using MenusTest = test::WholeWindowTest;

/// The entries without separators, notes ("No file yet"), and texts without a word, such as "+X".
std::vector<QAction*> commandsOf(const QList<QAction*>& actions) {
  std::vector<QAction*> commands;
  for (QAction* action : actions) {
    const bool isNote = !action->isEnabled() && action->objectName().isEmpty() && !action->isCheckable();
    if (!action->isSeparator() && !isNote && withoutMnemonic(action->text()).size() > 2) commands.push_back(action);
  }
  return commands;
}

void expectUniqueMnemonics(const QList<QAction*>& actions, const std::string& where) {
  QHash<QChar, QString> owners;
  for (const QAction* command : commandsOf(actions)) {
    const QChar letter = mnemonicOf(command->text());
    EXPECT_FALSE(letter.isNull()) << where << ": no mnemonic: " << command->text().toStdString();
    EXPECT_FALSE(owners.contains(letter))
        << where << ": " << command->text().toStdString() << ", " << owners.value(letter).toStdString();
    owners[letter] = command->text();
  }
}

void carryOut(MainWindow& window, const std::string& name, const std::vector<std::string>& words) {
  const Outcome done = window.workbench().scripts.carryOut(name, words);
  EXPECT_TRUE(done) << name << ": " << toString(done.error());
}

TEST_P(MenusTest, MnemonicsAreUniqueAndNoMenuIsTooLong) {
  const auto window = makeWindow();
  ASSERT_EQ(window->openScenario(sample("teaching"), true), std::nullopt);
  for (const char* view : {"Above", "A & B", "Side"}) carryOut(*window, "save-view", {view});
  expectUniqueMnemonics(window->menuBar()->actions(), "menu bar");
  for (QMenu* menu : window->findChildren<QMenu*>()) {
    emit menu->aboutToShow();
    const std::string name = menu->objectName().toStdString() + " " + menu->title().toStdString();
    expectUniqueMnemonics(menu->actions(), name);
    EXPECT_LE(commandsOf(menu->actions()).size(), kMostEntries) << name;
    EXPECT_LE(menu->sizeHint().height(), kLeastScreenHeight) << name;
  }
  for (const QWidget* widget : window->findChildren<QWidget*>()) {
    if (widget->contextMenuPolicy() != Qt::ActionsContextMenu) continue;
    expectUniqueMnemonics(widget->actions(), widget->objectName().toStdString());
  }
}

/// Alt and a letter has no effect if both a menu and a label have this letter.
TEST_P(MenusTest, NoLabelOfAPanelHasTheMnemonicOfAMenu) {
  const auto window = makeWindow();
  QString letters;
  for (const QAction* title : window->menuBar()->actions()) letters += mnemonicOf(title->text());
  const auto expectFree = [&letters](const QString& text) {
    const QChar letter = mnemonicOf(text);
    EXPECT_TRUE(letter.isNull() || !letters.contains(letter)) << text.toStdString();
  };
  for (const QLabel* label : window->findChildren<QLabel*>()) {
    if (label->buddy() != nullptr) expectFree(label->text());
  }
  for (const QAbstractButton* button : window->findChildren<QAbstractButton*>()) expectFree(button->text());
}

TEST_P(MenusTest, MnemonicsOfTheMenuOfTheSceneAreUnique) {
  const auto window = makeWindow();
  ASSERT_EQ(window->openScenario(sample("teaching"), true), std::nullopt);
  window->show();
  window->workbench().scene.widget()->setFocus();
  carryOut(*window, "action", {"environment.build"});
  const std::vector<std::vector<std::string>> selections{{}, {"body", "O1"}, {"place", "P1"}};
  for (const auto& selection : selections) {
    if (!selection.empty()) carryOut(*window, "select", selection);
    carryOut(*window, "action", {"edit.context-menu"});
    auto* menu = window->findChild<QMenu*>(QStringLiteral("context-menu"));
    ASSERT_NE(menu, nullptr);
    expectUniqueMnemonics(menu->actions(), selection.empty() ? "scene" : selection[0]);
    menu->close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
}

TEST_P(MenusTest, EveryActionIsInAMenuAndSubmenusAreNoDeeperThanOne) {
  const auto window = makeWindow();
  const ActionCatalogue& actions = window->workbench().actions;
  for (const ActionSpec& spec : actions.specs()) {
    const QString path = menuPath(*actions[QLatin1String(spec.id)]);
    EXPECT_FALSE(path.isEmpty()) << spec.id << " is in no menu: its row has no place, or one in an unknown menu";
    EXPECT_LE(path.count(QLatin1Char('>')), 1) << spec.id;
  }
}

/// Six menus are read at first sight. Equal places would leave the order to the order of the features.
TEST_P(MenusTest, SixMenusAndEveryPlaceIsTakenOnce) {
  const auto window = makeWindow();
  EXPECT_EQ(window->menuBar()->actions().size(), 6);
  std::set<std::tuple<std::string, int, int>> places;
  const auto expectFree = [&](const MenuPlace& place, const char* id) {
    if (place.menu[0] == 0 && place.group == 0) return;
    EXPECT_TRUE(places.emplace(place.menu, place.group, place.order).second) << id;
  };
  for (const MenuSpec& menu : menuTable()) expectFree(menu.place, menu.id);
  for (const ActionSpec& spec : window->workbench().actions.specs()) expectFree(spec.place, spec.id);
}

/// The paths "View > Layers > Path" of every action and "View > Layers" of every submenu.
QStringList pathsOf(MainWindow& window) {
  QStringList paths;
  for (const QMenu* menu : window.menuBar()->findChildren<QMenu*>() + window.findChildren<QMenu*>()) {
    for (const QAction* entry : menu->actions()) {
      const QString path = menuPath(*entry);
      if (!path.isEmpty()) paths << path + QStringLiteral(" > ") + commandName(entry->text());
    }
  }
  return paths;
}

/// Null if the text begins with a path of the window; else the text's beginning.
QString unknownPath(const QString& text, const QStringList& paths) {
  for (const QString& path : paths) {
    if (text.startsWith(path) && !text.mid(path.size()).startsWith(QStringLiteral(" > "))) return {};
  }
  return text.left(70);
}

int expectKnownPaths(MainWindow& window, const QString& text, const std::string& where) {
  QStringList titles;
  for (const QAction* title : window.menuBar()->actions()) titles << withoutMnemonic(title->text());
  const QStringList paths = pathsOf(window);
  const QRegularExpression pattern(QStringLiteral("\\b(?:%1) > ").arg(titles.join(QLatin1Char('|'))),
                                   QRegularExpression::UseUnicodePropertiesOption);
  int found = 0;
  for (auto matches = pattern.globalMatch(text); matches.hasNext(); ++found) {
    const QString unknown = unknownPath(text.mid(matches.next().capturedStart()), paths);
    EXPECT_TRUE(unknown.isNull()) << where << " names no menu path: " << unknown.toStdString();
  }
  return found;
}

QString plainText(QString html) {
  html.remove(QRegularExpression(QStringLiteral("<[^>]*>")));
  return html.replace(QStringLiteral("&gt;"), QStringLiteral(">"))
      .replace(QStringLiteral("&apos;"), QStringLiteral("'"));
}

QString textOf(const QString& name) {
  QFile file(name);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
  return QString::fromUtf8(file.readAll());
}

TEST_P(MenusTest, MenuPathsThatDocumentsNameExist) {
  const auto window = makeWindow();
  const QString root = QString::fromStdString(test::sourceDirectory()) + QLatin1Char('/');
  int found = expectKnownPaths(*window, plainText(textOf(root + "resources/i18n/glissade_fr.ts")), "a text");
  EXPECT_GT(found, 5);
  const auto pages = manualPages(manualFacts(*window, window->workbench().actions));
  ASSERT_TRUE(pages);
  for (const auto& page : *pages)
    found += expectKnownPaths(*window, plainText(page.content.html), page.name.toStdString());
  EXPECT_GT(found, 50);
  if (QLatin1String(GetParam()) != QLatin1String("en")) return;
  QStringList documents{root + "README.md", root + "CHANGELOG.md", root + "widgets/README.md"};
  for (QDirIterator samples(root + "samples", {"*.md"}, QDir::Files, QDirIterator::Subdirectories);
       samples.hasNext();) {
    documents << samples.next();
  }
  int inDocuments = 0;
  for (const QString& file : documents) inDocuments += expectKnownPaths(*window, textOf(file), file.toStdString());
  EXPECT_GT(inDocuments, 3);
}

INSTANTIATE_TEST_SUITE_P(Languages, MenusTest, testing::Values("en", "fr"));

}  // namespace
}  // namespace glissade
