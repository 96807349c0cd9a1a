// Scripts steer, change, save, open and replay runs in the window.
#include <QRegularExpression>

#include "tests/app/window_fixture.h"

namespace {

using namespace glissade::test;

class ReplayWindow : public WindowTest {
 protected:
  void expectGood(const WindowResult& result) { EXPECT_EQ(result.exitCode, 0) << result.errors.toStdString(); }
  QString record() const { return folder.filePath(QStringLiteral("run.json")); }
};

const QString kSteeredRun = QStringLiteral(
    "select-operator novice\naction run.start\nsteps 60\nset alpha 0.6\nsteps 50\naction run.pause\nsteps 10\n"
    "action run.pause\nkey press W\nsteps 50\nset contact_samples 3\nsteps 60\naction run.stop\n");

TEST_F(ReplayWindow, ARunWithChangedParametersReplaysAndIsShownAtAnyStep) {
  const QString early = folder.filePath(QStringLiteral("early.png"));
  const QString late = folder.filePath(QStringLiteral("late.png"));
  const QString earlyAgain = folder.filePath(QStringLiteral("early-again.png"));
  expectGood(run(QStringLiteral("environment-1"),
                 kSteeredRun + QStringLiteral("save-recording %1\nreplay %1\nexpect-replay same\nseek 100\n"
                                              "screenshot %2\nseek 220\nscreenshot %3\nseek 100\nscreenshot %4\n"
                                              "action replay.close\nexpect-replay closed\nexpect stopped\n")
                                   .arg(record(), early, late, earlyAgain)));
  const QImage first(early);
  EXPECT_GT(difference(first, QImage(late)).share, 0.001);
  EXPECT_EQ(difference(first, QImage(earlyAgain)).share, 0.0);
}

TEST_F(ReplayWindow, ARecordingBringsItsScenarioAndIsReplayedWithOtherParameters) {
  expectGood(run(QStringLiteral("environment-1"), kSteeredRun + QStringLiteral("save-recording %1\n").arg(record())));
  expectGood(
      run(QString(), QStringLiteral("replay %1\nexpect-replay same\naction replay.step\naction replay.step-back\n"
                                    "action replay.close\nset alpha 0.05\naction replay.again\n"
                                    "expect-replay another\naction replay.last\nexpect-replay same\n")
                         .arg(record())));
}

TEST_F(ReplayWindow, SemanticEditsWhileTheRunGoesOnReplayToo) {
  const QString scenario = kSource + QStringLiteral("/samples/shape-game/tight-circle.json");
  expectGood(run(scenario, QStringLiteral("action run.start\nsteps 1\nselect place P9\naction place.forbid\nsteps 3\n"
                                          "action place.forbid\nselect place P7\nattribute complexity 30\n"
                                          "wait solved 20000\nsave-recording %1\nreplay %1\nexpect-replay same\n"
                                          "seek 100000\nexpect-replay same\n")
                               .arg(record())));
}

TEST_F(ReplayWindow, ARecordingThatWasTamperedWithDiffers) {
  expectGood(run(QStringLiteral("environment-1"), kSteeredRun + QStringLiteral("save-recording %1\n").arg(record())));
  QFile file(record());
  ASSERT_TRUE(file.open(QIODevice::ReadWrite));
  QString text = QString::fromUtf8(file.readAll());
  text.replace(QStringLiteral("\"seed\": 1"), QStringLiteral("\"seed\": 2"));
  text.remove(
      QRegularExpression(QStringLiteral(",\\s*\"checksum\": \"[^\"]*\"")));  // otherwise the file counts as damaged
  file.resize(0);
  file.write(text.toUtf8());
  file.close();
  expectGood(
      run(QStringLiteral("environment-1"), QStringLiteral("replay %1\nexpect-replay different\n").arg(record())));
  const WindowResult unmet =
      run(QStringLiteral("environment-1"), QStringLiteral("replay %1\nexpect-replay same\n").arg(record()));
  EXPECT_EQ(unmet.exitCode, 1);
}

TEST_F(ReplayWindow, WhatCannotBeReplayedIsSaid) {
  const WindowResult missing = run(QStringLiteral("environment-1"), QStringLiteral("replay /nowhere/run.json\n"));
  EXPECT_EQ(missing.exitCode, 3);
  EXPECT_TRUE(missing.errors.contains(QStringLiteral("line 1"))) << missing.errors.toStdString();
  EXPECT_EQ(run(QStringLiteral("environment-1"), QStringLiteral("save-recording %1\n").arg(record())).exitCode, 2);
  EXPECT_EQ(run(QStringLiteral("environment-1"), QStringLiteral("seek 5\n")).exitCode, 3);
}

TEST_F(ReplayWindow, ThePathIsColouredByItsAuthors) {
  const QString plain = folder.filePath(QStringLiteral("plain.png"));
  const QString byAuthor = folder.filePath(QStringLiteral("by-author.png"));
  expectGood(run(QStringLiteral("environment-1"),
                 QStringLiteral("select-operator expert\naction run.start\nwait solved 20000\nscreenshot %1\n"
                                "action view.path-authors\nscreenshot %2\n")
                     .arg(plain, byAuthor)));
  EXPECT_GT(difference(QImage(plain), QImage(byAuthor)).share, 0.0005);
}

}  // namespace
