// Refusals, kept paths, measuring and the log, in the window as a person would use them.
#include "engine/files/scenario_io.h"
#include "tests/app/window_fixture.h"

namespace {

using namespace glissade;
using namespace glissade::test;

class DailyWindow : public WindowTest {
 protected:
  void expectGood(const WindowResult& result) { EXPECT_EQ(result.exitCode, 0) << result.errors.toStdString(); }

  /// A cube of 0.2 m that starts at x, between two blocks with a gap of 0.4 m.
  QString scenarioWithCubeAt(double x) {
    Scenario scenario;
    scenario.object.first().id = "cube";
    scenario.object.first().name = "cube";
    scenario.object.first().geometry = BoxGeometry{{0.2, 0.2, 0.2}};
    for (const double side : {-1.0, 1.0}) {
      BodyDescription block;
      block.name = side < 0.0 ? "left" : "right";
      block.id = BodyId(block.name);
      block.geometry = BoxGeometry{{0.2, 1.0, 1.0}};
      block.pose.position.x() = side * 0.3;
      scenario.bodies.push_back(block);
    }
    scenario.start.position.x() = x;
    scenario.goal = Pose::translation({0.0, 0.0, 1.5});
    scenario.workspace = Box3(Vector3::Constant(-2.0), Vector3::Constant(2.0));
    scenario.planner = "auto";
    QFile file(folder.filePath(QStringLiteral("cube.json")));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(writeScenario(scenario)));
    return file.fileName();
  }
};

TEST_F(DailyWindow, WhatIsRefusedIsSaidAndCanBeAllowedOrMovedClear) {
  const QString cube = scenarioWithCubeAt(0.103);
  expectGood(run(cube, QStringLiteral("expect-refusal none\n"
                                      "action run.start\nexpect failed\nexpect-refusal right\n"
                                      "action refusal.show\naction refusal.allow\nexpect-refusal none\n"
                                      "action run.start\nwait ended 20000\nexpect solved\nexpect-refusal none\n"
                                      "action edit.undo\naction run.start\nexpect-refusal right\n"
                                      "action assembly.free-ends\nexpect-refusal none\n"
                                      "action run.start\nwait ended 20000\nexpect solved\n")));
  expectGood(run(cube, QStringLiteral("action run.start\nexpect-refusal right\naction refusal.close\n"
                                      "expect-refusal none\n")));
}

TEST_F(DailyWindow, PathsAreKeptWithTheScenarioAndProvedAgain) {
  const QString cube = scenarioWithCubeAt(0.0);
  const QString saved = folder.filePath(QStringLiteral("saved.json"));
  expectGood(
      run(cube, QStringLiteral("expect-kept-paths 0\n"
                               "action run.start\nwait ended 20000\nexpect solved\n"
                               "action paths.keep\nexpect-kept-paths 1\nexpect-kept-path @1 proved\n"
                               "action edit.undo\nexpect-kept-paths 0\naction edit.redo\nexpect-kept-paths 1\n"
                               "rename-path @1 first\nexpect-kept-path first proved\nselect-strategy birrt\n"
                               "action run.restart-new-seed\nwait ended 20000\nexpect solved\n"
                               "save %1\nexpect-kept-paths 2\n"
                               "open %1\nexpect-kept-paths 2\nexpect-path certified\nexpect-modified no\n"
                               "expect-kept-path first proved\nexpect-kept-path @2 proved\n"
                               "open-kept-path first\nexpect-path certified\n"
                               "show-path first yes\nshow-path @2 yes\n"
                               "select-path first\naction paths.pin\nexpect-kept-path @1 proved\nexpect-modified yes\n"
                               "place left -150,0,0 0,0,0\nexpect-kept-path first blocked\n"
                               "action edit.undo\nexpect-kept-path first proved\n"
                               "select-path first\naction paths.remove\nexpect-kept-paths 1\n")
                    .arg(saved)));
}

TEST_F(DailyWindow, ARunAtAPaceIsReplayedWithIt) {
  const QString recording = folder.filePath(QStringLiteral("run.json"));
  expectGood(run(scenarioWithCubeAt(0.0), QStringLiteral("set pace 40\nexpect-value pace 40\n"
                                                         "action run.start\nwait ended 20000\nexpect solved\n"
                                                         "save %2\nset pace 0\nexpect-value pace 0\n"
                                                         "save-recording %1\nreplay %1\nexpect-value pace 0\n"
                                                         "expect-replay same\n")
                                              .arg(recording, folder.filePath(QStringLiteral("saved.json")))));
  QFile file(recording);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_TRUE(file.readAll().simplified().replace(" ", "").contains("\"pace\":40.0"));
}

TEST_F(DailyWindow, MeasuresWhatIsClicked) {
  // The view is from the front and orthographic: the blocks are 0.4 m apart, 0.2 m wide and 1 m high.
  expectGood(run(scenarioWithCubeAt(0.0), QStringLiteral("action layer.object\naction layer.ends\n"
                                                         "action view.orthographic\naction view.front\n"
                                                         "action measure.clearance\nclick 214 466\nclick 382 466\n"
                                                         "expect-measure 400\n"
                                                         "action measure.distance\nclick 187 328\nclick 410 328\n"
                                                         "expect-measure 800\n"
                                                         "action measure.angle\nclick 214 466\nclick 382 466\n"
                                                         "expect-measure 0.00\n"
                                                         "action measure.radius\nclick 214 466\n"
                                                         "expect-measure cylinder\n")));
}

TEST_F(DailyWindow, ABodyIsPlacedByAFaceThatIsClicked) {
  expectGood(run(scenarioWithCubeAt(0.0), QStringLiteral("action layer.object\naction layer.ends\n"
                                                         "action view.orthographic\naction view.front\n"
                                                         "expect-placed-by file\naction assembly.pick-frame\n"
                                                         "click 214 466\nexpect-placed-by Picked\n")));
}

TEST_F(DailyWindow, TheLogTellsRunsAndRefusals) {
  expectGood(run(scenarioWithCubeAt(0.103), QStringLiteral("action run.start\nexpect-log penetrates\n"
                                                           "action panel.log\naction log.copy\n")));
}

}  // namespace
