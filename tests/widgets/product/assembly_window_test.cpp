// Parts, bodies and the ends of the motion are arranged in the window as a person would.
#include "tests/app/window_fixture.h"
#include "tests/engine/support/part_fixture.h"
#include "tests/engine/support/step_files.h"

namespace {

using namespace glissade::test;

class AssemblyWindow : public WindowTest {
 protected:
  void expectGood(const WindowResult& result) { EXPECT_EQ(result.exitCode, 0) << result.errors.toStdString(); }
  void expectRefused(const QString& scenario, const QString& script, const char* why) {
    const WindowResult result = run(scenario, script);
    EXPECT_NE(result.exitCode, 0) << script.toStdString();
    EXPECT_TRUE(result.errors.contains(QLatin1String(why))) << result.errors.toStdString();
  }
  /// The middle of the 3D view, which shows only the scene.
  static QImage middle(const QString& file) { return QImage(file).copy(QRect(380, 120, 540, 500)); }

  const QString shapeGame = kSource + QStringLiteral("/samples/shape-game/tight-circle.json");
};

TEST_F(AssemblyWindow, APartOfAProductIsTakenOutOfItFromItsFilesAlone) {
  const TrayProduct product;
  const QString saved = folder.filePath(QStringLiteral("tray.json"));
  expectGood(
      run(QString(), QStringLiteral("new-scenario %1 0.001 Z\n"
                                    "add-part %2 static 0.001 Z\n"
                                    "expect-place tray 0,0,0\n"
                                    "expect-place goal nowhere\n"
                                    "action run.start\nwait ended 20000\nexpect solved\n"
                                    "save %3\nopen %3\n"
                                    "action run.start\nwait ended 20000\nexpect solved\n"
                                    "select body tray\naction assembly.moves\n"
                                    "expect-place block 0,0,0\nexpect-place tray nowhere\n"
                                    "action edit.undo\nexpect-place tray 0,0,0\n")
                         .arg(QString::fromStdString(product.block), QString::fromStdString(product.tray), saved)));
  expectRefused(QString(), QStringLiteral("new-scenario gone.stl 0.001 Z\n"), "cannot be opened");
}

TEST_F(AssemblyWindow, APartIsTakenOutOfAProductInOneStepFile) {
  const QString saved = folder.filePath(QStringLiteral("unit.json"));
  const QString unit = QString::fromStdString(stepFile("unit.step"));
  expectGood(run(QString(), QStringLiteral("new-scenario %1:pin 1 Z\n"
                                           "add-part %1 static 1 Z\n"
                                           "expect-place pin#2 0,0,0\nexpect-place start 0,0,10\n"
                                           "action run.start\nwait ended 20000\nexpect solved\n"
                                           "save %2\nopen %2\n"
                                           "select body pump.housing\naction assembly.moves\n"
                                           "expect-place start 300,0,20\nexpect-place pin 0,0,0\n"
                                           "place pin#2 50,0,0 0,0,90\nexpect-place pin#2 50,0,0\n"
                                           "action edit.undo\naction edit.undo\nexpect-place start 0,0,10\n"
                                           "select body plate\naction assembly.remove\nexpect-place plate nowhere\n"
                                           "action edit.undo\nexpect-place plate 0,0,0\n")
                                .arg(unit, saved)));
  expectRefused(QString(), QStringLiteral("new-scenario %1:pim 1 Z\n").arg(unit), "pin#2");
}

TEST_F(AssemblyWindow, AGroupMovesAsOneAndItsBodiesStayBodiesOfTheProduct) {
  const QString saved = folder.filePath(QStringLiteral("group.json"));
  const QString unit = QString::fromStdString(stepFile("unit.step"));
  expectGood(run(QString(), QStringLiteral("new-scenario %1:pin 1 Z\nadd-part %1 static 1 Z\n"
                                           "select bodies pin#2+plate\naction assembly.moves\n"
                                           "expect-place pin 0,0,0\nexpect-place plate nowhere\n"
                                           "expect-place pin#2 nowhere\n"
                                           // The earlier object joins the group.
                                           "select bodies pin+pin#2+plate\naction assembly.moves\n"
                                           "expect-place pin nowhere\nsave %2\nopen %2\n"
                                           "plan-sequence all\nexpect-sequence parts 4\n"
                                           "action run.start\nwait ended 20000\nexpect solved\n"
                                           "select body pump.housing\naction assembly.moves\n"
                                           "expect-place pin 0,0,0\nexpect-place plate 0,0,0\n"
                                           "action edit.undo\nexpect-place plate nowhere\n")
                                .arg(unit, saved)));
}

TEST_F(AssemblyWindow, WhatIsLeftOutIsKeptByTheScenarioAndPutBack) {
  const QString saved = folder.filePath(QStringLiteral("left.json"));
  const QString picture = folder.filePath(QStringLiteral("left.png"));
  const QString unit = QString::fromStdString(stepFile("unit.step"));
  expectGood(run(QString(), QStringLiteral("new-scenario %1:pin 1 Z\nadd-part %1 static 1 Z\n"
                                           "select body plate\naction assembly.leave-out\n"
                                           "expect-place plate nowhere\nsave %2\nopen %2\n"
                                           "expect-place plate nowhere\naction panel.scene\nscreenshot %3\n"
                                           "choose-left-out plate\naction assembly.put-back\n"
                                           "expect-place plate 0,0,0\naction edit.undo\nexpect-place plate nowhere\n")
                                .arg(unit, saved, picture)));
  QFile file(saved);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_TRUE(file.readAll().contains("\"left_out\""));
}

/// Two boxes are in the same place, and one box is beside them.
TEST_F(AssemblyWindow, VariantsAreSaidAndOneIsChosen) {
  const QString scenario = folder.filePath(QStringLiteral("variants.json"));
  QFile file(scenario);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  const char* body = R"({"id": "%1", "geometry": {"box": [0.1, 0.1, %2]},
    "pose": {"position": [%3, 0, 0], "orientation": [0, 0, 0, 1]}})";
  QStringList bodies;
  bodies << QString::fromLatin1(body).arg(QStringLiteral("short"), QStringLiteral("0.08"), QStringLiteral("0"))
         << QString::fromLatin1(body).arg(QStringLiteral("long"), QStringLiteral("0.1"), QStringLiteral("0"))
         << QString::fromLatin1(body).arg(QStringLiteral("post"), QStringLiteral("0.1"), QStringLiteral("0.4"));
  file.write(QStringLiteral(R"({"format": "glissade-scenario", "version": 1, "bodies": [%1],
    "object": {"id": "part", "geometry": {"sphere": {"radius": 0.05}}},
    "start": {"position": [0, 1, 0], "orientation": [0, 0, 0, 1]}, "goal": "out",
    "workspace": {"min": [-2, -2, -2], "max": [2, 2, 2]}})")
                 .arg(bodies.join(QLatin1Char(',')))
                 .toUtf8());
  file.close();
  const QString picture = folder.filePath(QStringLiteral("variants.png"));
  expectGood(run(scenario, QStringLiteral("expect-variants 1\nscreenshot %1\nchoose-variant long\n"
                                          "expect-place short nowhere\nexpect-place long 0,0,0\nexpect-variants 0\n"
                                          "action edit.undo\nexpect-place short 0,0,0\nexpect-variants 1\n")
                               .arg(picture)));
}

TEST_F(AssemblyWindow, AMobileBodyIsDraggedAndTheCellsFollowAsIfItHadAlwaysBeenThere) {
  const QString dragged = folder.filePath(QStringLiteral("dragged.png"));
  const QString fresh = folder.filePath(QStringLiteral("fresh.png"));
  const QString back = folder.filePath(QStringLiteral("back.png"));
  const QString before = folder.filePath(QStringLiteral("before.png"));
  // A selected body is gripped also behind the wall.
  expectGood(
      run(shapeGame, QStringLiteral("action layer.mobile-cells\nselect body O3\n"
                                    "action assembly.arrange\nscreenshot %1\ndrag 272 316 332 356\nscreenshot %2\n"
                                    "action environment.build\nscreenshot %3\n"
                                    "action edit.undo\nscreenshot %4\naction edit.redo\n"
                                    "action run.start\nwait ended 40000\nexpect solved\n")
                         .arg(before, dragged, fresh, back)));
  EXPECT_GT(difference(middle(before), middle(dragged)).share, 0.01);
  EXPECT_EQ(middle(dragged), middle(fresh));
  EXPECT_EQ(middle(before), middle(back));
}

TEST_F(AssemblyWindow, TheGizmoMovesTurnsAndAlignsWhatIsSelected) {
  const QString picture = folder.filePath(QStringLiteral("arranging.png"));
  expectGood(run(QStringLiteral("teaching"),
                 QStringLiteral("action assembly.arrange\nexpect-arranging yes\nselect body O5\n"
                                "set-steps 50mm 30deg\naction assembly.snap\n"
                                "drag-handle x 70 -20\nexpect-place O5 1875,1575,300\n"
                                "drag-handle rz 40 0\nexpect-place O5 1875,1575,300\n"
                                "action edit.undo\naction edit.undo\nexpect-place O5 1375,1575,300\n"
                                // A drag that Esc cancels is no edit, and does not leave the mode.
                                "hold-handle rz 40 0\nscreenshot %1\nkey tap Esc\nexpect-place O5 1375,1575,300\n"
                                "expect-arranging yes\n"
                                // Consecutive keys are one edit.
                                "key tap Right\nkey tap Right\nkey tap PgUp\nkey tap Up\nkey tap Shift+Left\n"
                                "expect-place O5 1475,1625,350\n"
                                "action edit.undo\nexpect-place O5 1375,1575,300\n"
                                "drag-handle z 0 -200\nexpect-outside O5\naction assembly.fit-workspace\n"
                                "expect-outside none\naction edit.undo\naction edit.undo\n"
                                // The front of the body is aligned with the front of O3, then flipped; both are one
                                // edit.
                                "action assembly.align\nexpect-arranging no\nclick 298 224\nclick 423 277\n"
                                "expect-arranging yes\naction panel.scene\nexpect-place O5 1393.495,775,300\n"
                                "action assembly.flip\nexpect-place O5 1375,1025,300\n"
                                "action edit.undo\nexpect-place O5 1375,1575,300\n"
                                "key tap Esc\nexpect-arranging no\n"
                                "action assembly.arrange\nopen %2\nexpect-arranging no\n")
                     .arg(picture, kSource + QStringLiteral("/samples/teaching/scenario.json"))));
  expectLike(picture, QStringLiteral("arranging"));
  expectRefused(QStringLiteral("teaching"), QStringLiteral("drag-handle x 70 -20\n"), "cannot be taken now");
}

TEST_F(AssemblyWindow, WhatIsArrangedMeetsFeaturesOfOtherBodies) {
  expectGood(run(QStringLiteral("bolted-brackets"),
                 // The drag of an arrow snaps to a face and is one edit. Without snapping the body stays where it was
                 // dropped.
                 QStringLiteral("action view.isometric\nselect body rod-nut-2\naction assembly.arrange\n"
                                "hold-handle x 20 -10\nexpect-snap bracket-2\nkey tap Esc\nexpect-snap none\n"
                                "drag-handle x 20 -10\nexpect-place rod-nut-2 -23.5,0,34\naction edit.undo\n"
                                "action assembly.snap-features\nhold-handle x 20 -10\nexpect-snap none\nkey tap Esc\n"
                                // The hint names the item under the pointer. A face of the nut is aligned with the
                                // plate.
                                "action assembly.align\nhover 166 281\nexpect-hint rod-nut-2\nclick 166 281\n"
                                "hover 267 326\nexpect-hint plate\nexpect-place rod-nut-2 -30,0,34\n"
                                "click 267 326\nexpect-arranging yes\nexpect-place rod-nut-2 -30,-8.299,6.5\n"
                                "action edit.undo\nexpect-place rod-nut-2 -30,0,34\n"
                                // Measuring ends the alignment; Esc leaves it.
                                "action assembly.align\naction measure.distance\nexpect-arranging no\n"
                                "key tap Esc\naction assembly.align\nkey tap Esc\nexpect-arranging no\n")));
}

TEST_F(AssemblyWindow, WhereThingsAreIsKeptByTheFile) {
  const QString saved = folder.filePath(QStringLiteral("moved.json"));
  expectGood(run(shapeGame, QStringLiteral("place O3 1000,500,700 10,20,30\nexpect-place O3 1000,500,700\n"
                                           "place goal 2100,800,1300 0,0,0\n"
                                           "action assembly.swap\nexpect-place start 2100,800,1300\n"
                                           "action assembly.goal-out\nexpect-place goal nowhere\n"
                                           "save %1\nopen %1\nexpect-place O3 1000,500,700\n"
                                           "expect-place start 2100,800,1300\nexpect-place goal nowhere\n"
                                           "select body O3\naction assembly.remove\nexpect-place O3 nowhere\n"
                                           "action edit.undo\nexpect-place O3 1000,500,700\n")
                                .arg(saved)));
  expectRefused(shapeGame, QStringLiteral("place O9 1,2,3 0,0,0\n"), "no such body");
  expectRefused(shapeGame, QStringLiteral("place O3 1,2 0,0,0\n"), "not three numbers");
}

TEST_F(AssemblyWindow, AnEndThatTouchesIsMovedClearOfIt) {
  // The cylinder's flat end lies on the wall's face, and a run refuses to begin there.
  const QString touching = QStringLiteral(
      "select body O3\nplace start 1000,500,1200 0,0,0\n"
      "place O3 1000,500,1200 0,0,0\n");
  expectGood(run(shapeGame, touching + QStringLiteral("action run.start\nwait ended 100\nexpect failed\n")));
  expectGood(run(QStringLiteral("teaching"), QStringLiteral("action assembly.free-ends\naction run.start\n"
                                                            "wait ended 40000\nexpect solved\n")));
}

TEST_F(AssemblyWindow, APathThatWasFoundIsProvedAgainWhereBodiesMoved) {
  const QString found = folder.filePath(QStringLiteral("found.csv"));
  const QString again = folder.filePath(QStringLiteral("again.csv"));
  const QString picture = folder.filePath(QStringLiteral("blocked.png"));
  expectGood(run(shapeGame, QStringLiteral("select-strategy contact-birrt\naction run.start\nwait ended 40000\n"
                                           "expect-path certified\nexport %1\n"
                                           "place O3 706,1015,1052 0,0,0\nexpect idle\nexpect-path O3\n"
                                           "action panel.path\naction path.first-blocked\nscreenshot %2\n"
                                           "place O3 1100,1500,1300 0,0,0\nexpect-path certified\n"
                                           "place start 240,1100,2010 0,0,0\nexpect-path -\n"
                                           "action edit.undo\nexpect-path certified\nexport %3\n"
                                           "action assembly.swap\nexpect-path -\n"
                                           "action run.start\nsteps 1\nexpect-path none\n")
                                .arg(found, picture, again)));
  const auto contentOf = [](const QString& name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  };
  EXPECT_FALSE(contentOf(found).isEmpty());
  EXPECT_EQ(contentOf(found), contentOf(again));
  expectLike(picture, QStringLiteral("blocked"));
}

TEST_F(AssemblyWindow, APathIsReadFromAFile) {
  const QString found = folder.filePath(QStringLiteral("found.csv"));
  expectGood(run(shapeGame, QStringLiteral("select-strategy auto\naction run.start\nwait ended 40000\n"
                                           "export %1\nopen-path %1\nexpect-path certified\n"
                                           "place O3 240,1100,1800 0,0,0\nexpect-path O3\n")
                                .arg(found)));
  expectGood(run(QStringLiteral("teaching"), QStringLiteral("open-path %1\nexpect-path -\n").arg(found)));
  expectRefused(QString(), QStringLiteral("open-path %1\n").arg(found), "no scenario is open");
  expectRefused(shapeGame, QStringLiteral("open-path %1\n").arg(shapeGame), "glissade-path");
  expectRefused(shapeGame, QStringLiteral("action run.start\nsteps 1\nopen-path %1\n").arg(found), "Stop the run");
}

TEST_F(AssemblyWindow, NothingIsArrangedWhileARunGoesOn) {
  expectGood(run(QStringLiteral("environment-2"), QStringLiteral("action assembly.arrange\naction run.start\nsteps 5\n"
                                                                 "expect planning\n")));
  expectRefused(QStringLiteral("environment-2"),
                QStringLiteral("action run.start\nsteps 5\nexpect planning\naction assembly.arrange\n"),
                "not possible now");
}

TEST_F(AssemblyWindow, OwnRulesChangeTheWayAreUndoneAndKept) {
  const QString saved = folder.filePath(QStringLiteral("rules.json"));
  expectGood(run(QStringLiteral("teaching"),
                 QStringLiteral("select-strategy own\naction environment.build\nexpect-way P2,P5,P3,P4,P1\n"
                                "rule node 0\nexpect-way P2,P6,P1\n"
                                "action edit.undo\nexpect-way P2,P5,P3,P4,P1\naction edit.redo\nexpect-way P2,P6,P1\n"
                                "save %1\nopen %1\nexpect-way P2,P6,P1\n")
                     .arg(saved)));
  expectRefused(QStringLiteral("teaching"), QStringLiteral("rule edge distance*place.hazard\n"), "place.hazard");
}

TEST_F(AssemblyWindow, ThePanelsLookAsTheyShould) {
  const QString picture = folder.filePath(QStringLiteral("assembly.png"));
  expectGood(run(shapeGame, QStringLiteral("action panel.scene\nselect body O3\nplace O3 700,300,1500 0,0,30\n"
                                           "action layer.mobile-cells\nscreenshot %1\n")
                                .arg(picture)));
  expectLike(picture, QStringLiteral("assembly"));
}

}  // namespace
