// The welcome page, the tour, "What's this?" and context menus, in the window as a person would use them.
#include "app/window/window_actions.h"
#include "tests/app/window_fixture.h"
#include "widgets/help/tour_steps.h"

namespace {

using namespace glissade;
using namespace glissade::test;

class HelpWindow : public WindowTest {
 protected:
  void expectGood(const WindowResult& result) { EXPECT_EQ(result.exitCode, 0) << result.errors.toStdString(); }
};

TEST(Tour, ItsStepsSayWhatToDoAndNameWhatIsThere) {
  ActionCatalogue actions(windowActions(), nullptr);
  ASSERT_EQ(tourSteps().size(), 11U);
  int ofActions = 0;
  for (const TourStep& step : tourSteps()) {
    EXPECT_FALSE(QString::fromUtf8(step.title).isEmpty());
    EXPECT_FALSE(QString::fromUtf8(step.text).isEmpty());
    EXPECT_FALSE(step.commands.empty()) << step.title;
    for (const QString& line : QStringList(step.commands.begin(), step.commands.end())) {
      const QStringList words = line.split(QLatin1Char(' '));
      EXPECT_TRUE(words[0] != QStringLiteral("action") || actions.find(words[1]) != nullptr) << line.toStdString();
    }
    const bool isAction = actions.find(QLatin1String(step.target)) != nullptr;
    ofActions += isAction ? 1 : 0;
    EXPECT_TRUE(isAction || step.isDone != nullptr) << step.title << " is never done";
  }
  EXPECT_GT(ofActions, 5);
}

TEST_F(HelpWindow, TheTourIsDoneFromBeginningToEnd) {
  QString script = QStringLiteral("expect-explained\naction help.tour\n");
  for (int step = 1; step <= 11; ++step) {
    script += QStringLiteral("expect-tour %1\nexpect-tour-mark\ntour do\n").arg(step);
    // GT tries the slot for long. A stopped run also completes the step.
    if (step == 3) script += QStringLiteral("steps 50\naction run.stop\nsteps 1\n");
    if (step == 4 || step == 8) script += QStringLiteral("wait ended 20000\n");
  }
  script += QStringLiteral(
      "expect-tour none\naction help.tour\ntour next\ntour next\nexpect-tour 3\ntour back\n"
      "expect-tour 2\ntour end\nexpect-tour none\n");
  expectGood(run(QString(), script));
}

TEST_F(HelpWindow, TheTourGoesOnWhenAPersonDoesTheStep) {
  expectGood(run(QString(), QStringLiteral("action help.tour\nopen-sample teaching/scenario.json\nexpect-tour 2\n"
                                           "action layer.places\nexpect-tour 3\n")));
}

TEST_F(HelpWindow, TheRightButtonOpensTheMenuOfWhatIsThere) {
  // A click beside everything opens the menu of the scene, one on the first wall the menu of the body, and one on a
  // shown place the menu of the place.
  expectGood(
      run(QStringLiteral("teaching"), QStringLiteral("action layer.object\naction view.top\n"
                                                     "right-click 10 10\nexpect-menu view.fit\n"
                                                     "right-click 233 324\nexpect-menu body.hide\n"
                                                     "action view.isometric\naction layer.places\n"
                                                     "right-click 475 333\n"
                                                     "expect-menu place.forbid\naction layer.places\nselect body O1\n"
                                                     "action edit.context-menu\nexpect-menu body.hide\n")));
}

}  // namespace
