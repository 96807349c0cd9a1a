// Scripts ask the window why no path was found.
#include "tests/app/window_fixture.h"

namespace {

using namespace glissade::test;

/// A cube of 0.4 m and a wall with a square window of 0.37 m.
const char* const kTooNarrow = R"({"format": "glissade-scenario", "version": 1, "planner": "birrt", "seed": 1,
  "object": {"id": "cube", "name": "Cube", "geometry": {"box": [0.4, 0.4, 0.4]}},
  "start": {"position": [-1.5, 0, 0], "orientation": [0, 0, 0, 1]},
  "goal": {"position": [1.5, 0, 0], "orientation": [0, 0, 0, 1]},
  "bodies": [
    {"id": "left", "name": "Left", "mobility": "static", "geometry": {"box": [0.2, 2.315, 5]},
     "pose": {"position": [0, -1.3425, 0], "orientation": [0, 0, 0, 1]}},
    {"id": "right", "name": "Right", "mobility": "static", "geometry": {"box": [0.2, 2.315, 5]},
     "pose": {"position": [0, 1.3425, 0], "orientation": [0, 0, 0, 1]}},
    {"id": "below", "name": "Below", "mobility": "static", "geometry": {"box": [0.2, 0.37, 2.315]},
     "pose": {"position": [0, 0, -1.3425], "orientation": [0, 0, 0, 1]}},
    {"id": "above", "name": "Above", "mobility": "static", "geometry": {"box": [0.2, 0.37, 2.315]},
     "pose": {"position": [0, 0, 1.3425], "orientation": [0, 0, 0, 1]}}],
  "workspace": {"min": [-2, -2, -2], "max": [2, 2, 2]}})";

class DifficultyWindow : public WindowTest {
 protected:
  QString tooNarrow() const {
    QFile file(folder.filePath(QStringLiteral("narrow.json")));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(kTooNarrow);
    return file.fileName();
  }
};

TEST_F(DifficultyWindow, TellsWhatStandsInTheWayAndShowsIt) {
  const QString before = folder.filePath(QStringLiteral("before.png"));
  const QString after = folder.filePath(QStringLiteral("after.png"));
  const QString hidden = folder.filePath(QStringLiteral("hidden.png"));
  const WindowResult result =
      run(tooNarrow(), QStringLiteral("action run.start\nsteps 800\naction run.stop\nscreenshot %1\n"
                                      "action difficulty.find\nshow-difficulty least\nshow-difficulty tightest\n"
                                      "show-difficulty frontier\nscreenshot %2\n"
                                      "action layer.difficulty\nscreenshot %3\naction difficulty.play\n"
                                      "action run.start\nsteps 5\nexpect-difficulty least -\n")
                           .arg(before, after, hidden));
  EXPECT_EQ(result.exitCode, 0) << result.errors.toStdString();
  EXPECT_GT(difference(QImage(before), QImage(after)).share, 0.005);
  EXPECT_GT(difference(QImage(after), QImage(hidden)).share, 0.002);
}

TEST_F(DifficultyWindow, OffersPlacesToHelpAndTakesTheHandThere) {
  const QString offered = folder.filePath(QStringLiteral("offered.png"));
  const QString hidden = folder.filePath(QStringLiteral("hidden.png"));
  const QString taken = folder.filePath(QStringLiteral("taken.png"));
  const WindowResult result =
      run(tooNarrow(), QStringLiteral("action run.start\nsteps 800\naction run.stop\nexpect-help places 0\n"
                                      "action difficulty.find\nexpect-help places 4\nexpect-help taken 0\n"
                                      "show-difficulty help-2\nscreenshot %1\naction layer.help\nscreenshot %2\n"
                                      "action layer.help\naction assist.go\nsteps 5\nexpect planning\n"
                                      "expect-help taken 2\nscreenshot %3\n"
                                      "action assist.go\nexpect-help taken 3\naction run.stop\n")
                           .arg(offered, hidden, taken));
  EXPECT_EQ(result.exitCode, 0) << result.errors.toStdString();
  EXPECT_GT(difference(QImage(offered), QImage(hidden)).share, 0.001);
  EXPECT_GT(difference(QImage(offered), QImage(taken)).share, 0.02);
}

/// The trees stay, and the hand is taken from one place to the next. After the last one the places are searched again.
TEST_F(DifficultyWindow, HelpsInARunThatGoesOnByHand) {
  const WindowResult result = run(
      tooNarrow(), QStringLiteral("select-operator hand\nselect-strategy interactive\naction run.start\n"
                                  "steps 200\naction assist.show\nexpect-help places 4\nexpect-help taken 0\n"
                                  "action assist.go\nsteps 1\nexpect-help taken 1\naction assist.go\n"
                                  "expect-help taken 2\naction assist.go\nexpect-help taken 3\naction assist.go\n"
                                  "expect-help taken 4\naction assist.go\nexpect-help taken 1\nkey press D\nsteps 40\n"
                                  "expect planning\nexpect-help taken 1\naction run.stop\nsteps 1\n"
                                  "expect-help places 0\n"));
  EXPECT_EQ(result.exitCode, 0) << result.errors.toStdString();
}

TEST_F(DifficultyWindow, IsAskedOnlyWhereThereIsNoPath) {
  const WindowResult idle = run(tooNarrow(), QStringLiteral("action difficulty.find\n"));
  EXPECT_EQ(idle.exitCode, 3);
  EXPECT_TRUE(idle.errors.contains(QStringLiteral("not possible now"))) << idle.errors.toStdString();
  EXPECT_EQ(run(tooNarrow(), QStringLiteral("show-difficulty least\n")).exitCode, 3);
  EXPECT_EQ(run(tooNarrow(), QStringLiteral("action assist.go\n")).exitCode, 3);
}

}  // namespace
