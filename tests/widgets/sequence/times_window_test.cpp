// The table of times in the whole window, in both languages: it is remembered, and its edits can be undone.
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>

#include "tests/app/whole_window.h"
#include "widgets/sequence/times_view.h"
#include "widgets/workbench/window_memory.h"

namespace glissade {
namespace {

class TimesWindowTest : public test::WholeWindowTest {
 protected:
  static void carryOut(const MainWindow& window, const std::string& command, const std::vector<std::string>& words) {
    const Outcome done = window.workbench().scripts.carryOut(command, words);
    EXPECT_TRUE(done) << toString(done.error());
  }
  static QPushButton* button(const MainWindow& window, const char* id) {
    return window.findChild<QPushButton*>(QLatin1String(id));
  }
};

TEST_P(TimesWindowTest, TheTableIsRememberedUntilTheNextStart) {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("settings.ini"));
  {
    const auto window = makeWindow();
    window->remember(std::make_unique<WindowMemory>(file), true);
    carryOut(*window, "set-time", {"fetch_s", "4.5"});
    carryOut(*window, "set-time", {"hold_s", "3600.5"});
  }
  const auto window = makeWindow();
  window->remember(std::make_unique<WindowMemory>(file), true);
  carryOut(*window, "expect-time", {"fetch_s", "4.5"});
  carryOut(*window, "expect-time", {"hold_s", "2"});
}

TEST_P(TimesWindowTest, EditsOfTheTableAreUndoneAndRedone) {
  const auto window = makeWindow();
  carryOut(*window, "set-time", {"fetch_s", "4.5"});
  carryOut(*window, "set-time", {"hold_s", "3"});
  button(*window, "times-reset-all")->click();
  carryOut(*window, "expect-time", {"fetch_s", "1.95"});
  button(*window, "times-undo")->click();
  carryOut(*window, "expect-time", {"fetch_s", "4.5"});
  carryOut(*window, "expect-time", {"hold_s", "3"});
  button(*window, "times-undo")->click();
  carryOut(*window, "expect-time", {"hold_s", "2"});
  button(*window, "times-redo")->click();
  carryOut(*window, "expect-time", {"hold_s", "3"});
}

TEST_P(TimesWindowTest, AFileThatIsNoTableChangesNothing) {
  const auto window = makeWindow();
  carryOut(*window, "set-time", {"fetch_s", "4.5"});
  EXPECT_FALSE(window->workbench().scripts.carryOut("open-times", {sample("teaching").toStdString()}));
  carryOut(*window, "expect-time", {"fetch_s", "4.5"});
}

/// The texts are the names of rows and pages, and the refusals.
TEST_P(TimesWindowTest, AllTextsAreInTheLanguage) {
  const auto window = makeWindow();
  carryOut(*window, "set-time", {"hold_s", "-1"});
  const bool french = QLatin1String(GetParam()) == QLatin1String("fr");
  const auto* view = window->findChild<TimesView*>();
  const QTableWidget* table = view->findChild<QTableWidget*>();
  for (const WorkTimeRow& row : workTimeRows()) {
    const auto found = table->findItems(QString::fromLatin1(row.meaning.english), Qt::MatchFixedString);
    EXPECT_EQ(found.isEmpty(), french) << row.meaning.english;
  }
  const QString trouble = view->findChild<QLabel*>(QStringLiteral("times-trouble"))->text();
  EXPECT_TRUE(
      trouble.contains(french ? QStringLiteral("n'est pas de 0 à 3600") : QStringLiteral("is not from 0 to 3600")))
      << trouble.toStdString();
}

INSTANTIATE_TEST_SUITE_P(Languages, TimesWindowTest, testing::Values("en", "fr"));

}  // namespace
}  // namespace glissade
