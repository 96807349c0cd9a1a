// Display modes, section planes and the clearance of a path in the whole window, without a display.
#include "tests/app/window_fixture.h"

namespace {

using namespace glissade::test;

class DisplayWindow : public WindowTest {
 protected:
  QString picture(const char* name) const { return folder.filePath(QLatin1String(name) + QStringLiteral(".png")); }
  double change(const char* before, const char* after) const {
    return difference(QImage(picture(before)), QImage(picture(after))).share;
  }
};

TEST_F(DisplayWindow, EveryModeIsAnotherPictureAndTheFirstComesBack) {
  const QString script = QStringLiteral(
                             "screenshot %1/edges.png\naction display.shaded\nscreenshot %1/shaded.png\n"
                             "action display.see-through\nscreenshot %1/through.png\n"
                             "action display.wireframe\nscreenshot %1/wire.png\n"
                             "action display.shaded-edges\nscreenshot %1/again.png\n")
                             .arg(folder.path());
  ASSERT_EQ(run(QStringLiteral("environment-1"), script).exitCode, 0);
  EXPECT_GT(change("edges", "shaded"), 0.0005);
  EXPECT_GT(change("edges", "through"), 0.01);
  EXPECT_GT(change("through", "wire"), 0.01);
  EXPECT_EQ(change("edges", "again"), 0.0);
}

TEST_F(DisplayWindow, ABodyHasAModeOfItsOwn) {
  const QString script = QStringLiteral(
                             "select body environment/wall_L1\nscreenshot %1/selected.png\n"
                             "action display-selected.wireframe\nscreenshot %1/own.png\n"
                             "action display-selected.as-view\nscreenshot %1/again.png\n")
                             .arg(folder.path());
  ASSERT_EQ(run(QStringLiteral("environment-1"), script).exitCode, 0);
  EXPECT_GT(change("selected", "own"), 0.001);
  EXPECT_EQ(change("selected", "again"), 0.0);
}

TEST_F(DisplayWindow, ASectionOpensBodiesAndCloses) {
  const QString script = QStringLiteral(
                             "screenshot %1/whole.png\nsection x 0.5\nscreenshot %1/open.png\n"
                             "section y 0.5\nscreenshot %1/two.png\nsection x off\nsection y off\n"
                             "screenshot %1/again.png\n")
                             .arg(folder.path());
  ASSERT_EQ(run(QStringLiteral("environment-1"), script).exitCode, 0);
  EXPECT_GT(change("whole", "open"), 0.01);
  EXPECT_GT(change("open", "two"), 0.005);
  EXPECT_LT(change("whole", "again"), 0.0002) << "the view cube after the view had another size";
  EXPECT_EQ(run(QStringLiteral("environment-1"), QStringLiteral("section w 0.5\n")).exitCode, 3);
  EXPECT_EQ(run(QStringLiteral("environment-1"), QStringLiteral("section x 1.5\n")).exitCode, 3);
}

TEST_F(DisplayWindow, SectionsAreAddedDraggedAndRemovedAndAGridIsShown) {
  const QString script = QStringLiteral(
                             "screenshot %1/whole.png\naction section.add-x\naction section.add-x\n"
                             "action section.add-z\nexpect-sections 3\nsection x 0.25\nscreenshot %1/set.png\n"
                             "drag-section 1 30 20\nscreenshot %1/dragged.png\nsection x off\nexpect-sections 2\n"
                             "action section.handles\naction section.pick-face\nclick 300 330\nexpect-sections 3\n"
                             "action section.remove-all\nexpect-sections 0\n"
                             "screenshot %1/again.png\naction layer.grid\nscreenshot %1/grid.png\n")
                             .arg(folder.path());
  const WindowResult outcome = run(QStringLiteral("environment-1"), script);
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
  EXPECT_GT(change("set", "dragged"), 0.005);
  EXPECT_LT(change("whole", "again"), 0.002) << "only the focus is elsewhere";
  EXPECT_GT(change("again", "grid"), 0.001);
}

TEST_F(DisplayWindow, TheRoadmapIsFaintOnceAPathIsShownAndAWishBringsItBack) {
  const QString script = QStringLiteral(
                             "select-operator expert\naction run.start\nwait ended 24000\nexpect solved\n"
                             "screenshot %1/faint.png\naction view.keep-roadmap\nscreenshot %1/kept.png\n"
                             "action path.tightest\nscreenshot %1/tightest.png\n"
                             "ghosts 40\nscreenshot %1/many.png\nghosts none\nscreenshot %1/none.png\n"
                             "ghosts 200mm\nscreenshot %1/spaced.png\n")
                             .arg(folder.path());
  const WindowResult outcome =
      run(QStringLiteral("environment-2"), script, {QStringLiteral("--seed"), QStringLiteral("6")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
  EXPECT_GT(change("faint", "kept"), 0.01);
  EXPECT_GT(change("kept", "tightest"), 0.001);
  EXPECT_GT(change("many", "none"), 0.002);
  EXPECT_GT(change("none", "spaced"), 0.001);
}

}  // namespace
