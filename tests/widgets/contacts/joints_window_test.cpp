// The joints of a product in the whole window, without a display.
#include "tests/app/window_fixture.h"
#include "tests/engine/support/step_files.h"

namespace {

using namespace glissade::test;

class JointsWindow : public WindowTest {
 protected:
  /// Opens the product with its bolt as the object, finds its joints, and runs `script`.
  WindowResult runOnProduct(const QString& script, const QStringList& options = {}) {
    const QString product = QString::fromStdString(stepFile("fits.step"));
    const QString open = QStringLiteral("new-scenario %1:bolt 1 Z\nadd-part %1 static 1 Z\naction joints.find\n");
    return run(QString(), open.arg(product) + script, options);
  }
  void expectGood(const WindowResult& result) { EXPECT_EQ(result.exitCode, 0) << result.errors.toStdString(); }
};

TEST_F(JointsWindow, TheTableHasTheJointsOfTheProduct) {
  expectGood(
      runOnProduct(QStringLiteral("expect-joints screw 1\nexpect-joints nut 1\nexpect-joints insert 1\n"
                                  "expect-joints pin 1\nexpect-joint nut nut recognised\nselect-joint screw screw\n"
                                  "action joints.isolate\n")));
}

TEST_F(JointsWindow, WhatAPersonSaysIsUndoneAndKeptByTheFile) {
  const QString saved = folder.filePath(QStringLiteral("joints.json"));
  expectGood(runOnProduct(QStringLiteral("select-joint screw screw\naction joints.dissolve\n"
                                         "expect-joint screw screw dissolved\nexpect-joints screw 0\n"
                                         "action edit.undo\nexpect-joint screw screw recognised\n"
                                         "action edit.redo\nexpect-joint screw screw dissolved\n"
                                         "select-joint insert dowel\naction joints.press-out\n"
                                         "expect-joint insert dowel pressed-out\n"
                                         "select-joint pin rod\naction joints.confirm\nsave %1\n"
                                         "open %1\naction joints.find\nexpect-joint screw screw dissolved\n"
                                         "expect-joint insert dowel pressed-out\nexpect-joint pin rod confirmed\n"
                                         "select-joint screw screw\naction joints.as-found\n"
                                         "expect-joint screw screw recognised\n")
                              .arg(saved)));
}

TEST_F(JointsWindow, AJointIsMadeOfTheSelectedBodiesAndGoesAgain) {
  expectGood(
      runOnProduct(QStringLiteral("select body block\nmake-joint flexible\n"
                                  "expect-joint flexible block made\nselect-joint flexible block\n"
                                  "action joints.dissolve\nexpect-joint flexible block none\n"
                                  "action edit.undo\nexpect-joint flexible block made\n")));
}

TEST_F(JointsWindow, AJointThatCannotBeIsRefusedBeforeAnythingChanges) {
  const WindowResult outcome = runOnProduct(QStringLiteral("select body block\nmake-joint pin\n"));
  EXPECT_EQ(outcome.exitCode, 2) << outcome.errors.toStdString();
  EXPECT_TRUE(outcome.errors.contains(QStringLiteral("one body only"))) << outcome.errors.toStdString();
}

/// Joints are found again after bodies have moved, but not after a fit was accepted.
TEST_F(JointsWindow, JointsAreFoundAgainWhereBodiesHaveMoved) {
  expectGood(
      runOnProduct(QStringLiteral("place screw 0,0,200 0,0,0\nexpect-joint screw screw none\n"
                                  "action edit.undo\nexpect-joint screw screw recognised\n")));
}

/// Without its joint, the screw is pulled out at its turn, and no longer unscrewed together with another screw.
TEST_F(JointsWindow, TheShownPlanFollowsTheJoints) {
  expectGood(run(QStringLiteral("roller-stand"),
                 QStringLiteral("action joints.find\nexpect-joints screw 4\nplan-sequence all\n"
                                "expect-row 8 screw_2\nexpect-row 8 turns\nselect-joint screw stand/screw_2\n"
                                "action joints.dissolve\nexpect-sequence end complete\nexpect-row 8 screw_2\n"
                                "expect-row 8 down\naction edit.undo\nexpect-sequence end complete\n"
                                "expect-row 8 turns\n")));
}

TEST_F(JointsWindow, AJointThatIsNotThereIsAnError) {
  EXPECT_EQ(runOnProduct(QStringLiteral("select-joint nut screw\n")).exitCode, 3);
  EXPECT_EQ(runOnProduct(QStringLiteral("select-joint rivet screw\n")).exitCode, 3);
}

/// The picture has the table with a dissolved joint, and the bodies of the chosen row as the view marks them.
TEST_F(JointsWindow, TheJointsOfAProductLookAsTheyDid) {
  const QString picture = folder.filePath(QStringLiteral("joints.png"));
  expectGood(runOnProduct(QStringLiteral("select-joint pin rod\naction joints.dissolve\nselect-joint nut nut\n"
                                         "screenshot %1\n")
                              .arg(picture)));
  expectLike(picture, QStringLiteral("joints"));
}

}  // namespace
