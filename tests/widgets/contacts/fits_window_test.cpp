// The fits of a STEP product in the whole window, without a display.
#include "tests/app/window_fixture.h"
#include "tests/engine/support/step_files.h"

namespace {

using namespace glissade::test;

class FitsWindow : public WindowTest {
 protected:
  /// Opens the product with one of its parts as the object, and runs `script`.
  WindowResult runWith(const char* part, const QString& script) {
    const QString product = QString::fromStdString(stepFile("fits.step"));
    const QString open = QStringLiteral("new-scenario %1:%2 1 Z\nadd-part %1 static 1 Z\naction fits.find\n");
    return run(QString(), open.arg(product, QLatin1String(part)) + script);
  }
};

TEST_F(FitsWindow, TheTableHasThePairsOfTheProduct) {
  const WindowResult outcome = runWith("screw", QStringLiteral("expect-fits thread 1\nexpect-fits press 1\n"
                                                               "expect-fits clash 1\nselect-fit screw plate\n"
                                                               "action fits.isolate\n"));
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
}

TEST_F(FitsWindow, WhatFitsDoesNotStopTheWork) {
  const WindowResult outcome =
      runWith("bolt", QStringLiteral("action run.start\nwait ended 20000\nexpect solved\nexpect-path certified\n"));
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
}

TEST_F(FitsWindow, WhatAPersonSaysIsUndoneAndKeptByTheFile) {
  const QString saved = folder.filePath(QStringLiteral("fits.json"));
  const WindowResult outcome = runWith("bolt", QStringLiteral("select-fit bolt nut\naction fits.thread\n"
                                                              "expect-fits thread 2\naction edit.undo\n"
                                                              "expect-fits thread 1\naction edit.redo\nsave %1\n"
                                                              "open %1\naction fits.find\nexpect-fits thread 2\n"
                                                              "select-fit bolt nut\naction fits.as-measured\n"
                                                              "expect-fits thread 1\n")
                                                   .arg(saved));
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
}

/// The picture has the table, and the two bodies of the chosen row as the view marks them.
TEST_F(FitsWindow, TheFitsOfAProductLookAsTheyDid) {
  const QString picture = folder.filePath(QStringLiteral("fits.png"));
  const WindowResult outcome = runWith("bolt", QStringLiteral("select-fit screw plate\nscreenshot %1\n").arg(picture));
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
  expectLike(picture, QStringLiteral("fits"));
}

/// A box of 2 x 1 x 1 inch is measured in inches, and a box of 10 m whose file states millimetres in millimetres.
TEST_F(FitsWindow, AProductIsShownInTheUnitOfItsFile) {
  const QString measured = QStringLiteral(
      "new-scenario %1 1 Z\naction view.front\naction view.fit\n"
      "action measure.distance\nclick-body object\nclick 250 300\nexpect-measure %2\n");
  for (const auto& [file, unit] : {std::pair("inch.step", "in,"), {"box.step", "mm,"}, {"large-box.step", "mm,"}}) {
    const QString product = QString::fromStdString(stepFile(file));
    const WindowResult outcome = run(QString(), measured.arg(product, QLatin1String(unit)));
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
  }
}

TEST_F(FitsWindow, APairThatIsNotThereIsAnError) {
  EXPECT_EQ(runWith("screw", QStringLiteral("select-fit screw moon\n")).exitCode, 3);
}

}  // namespace
