// The assembly plan of a product in the whole window, without a display.
#include <QStandardPaths>

#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/files/work_times_json.h"
#include "tests/app/window_fixture.h"
#include "tests/engine/support/step_files.h"

namespace {

using namespace glissade;
using namespace glissade::test;

class SequenceWindow : public WindowTest {
 protected:
  void expectGood(const WindowResult& result) { EXPECT_EQ(result.exitCode, 0) << result.errors.toStdString(); }
  WindowResult runOnStand(const QString& script, const QStringList& options = {}) {
    return run(QStringLiteral("roller-stand"), script, options);
  }
  QString file(const char* name) const { return folder.filePath(QLatin1String(name)); }
  QByteArray content(const char* name) const {
    QFile written(file(name));
    EXPECT_TRUE(written.open(QIODevice::ReadOnly)) << name;
    return written.readAll();
  }
};

/// Number of steps of the roller stand that an average hand reaches.
constexpr int kReached = 9;

TEST_F(SequenceWindow, AProductIsPlannedPlayedAndExploded) {
  expectGood(
      runOnStand(QStringLiteral("expect-sequence end none\nplan-sequence all\nexpect-sequence parts 10\n"
                                "expect-sequence steps 10\nexpect-sequence stuck 0\nexpect-sequence end complete\n"
                                "show-step 3\nscreenshot %1\naction sequence.show-product\nexplode 1\n"
                                "screenshot %2\n")
                     .arg(file("step.png"), file("exploded.png"))));
  EXPECT_GT(difference(QImage(file("step.png")), QImage(file("exploded.png"))).share, 0.01);
}

TEST_F(SequenceWindow, TheProductIsComparedWithAnotherRevision) {
  const QString stand = QString::fromStdString(sourceDirectory()) + "/samples/roller-stand/scenario.json";
  expectGood(runOnStand(QStringLiteral("compare-with %1\nexpect-revision same 0\n"
                                       "plan-sequence all\ncompare-with %1\nexpect-revision same 10\n"
                                       "screenshot %2\n")
                            .arg(stand, file("comparison.png"))));
  EXPECT_GT(QFile(file("comparison.png")).size(), 0);
}

TEST_F(SequenceWindow, TimesFollowThePlanAndTheNumberOfStations) {
  expectGood(
      runOnStand(QStringLiteral("times 3\nexpect-times stations 0\nplan-sequence all\nexpect-times stations 3\n"
                                "times 1\nexpect-times stations 1\n")));
}

/// Each of the ten parts takes one second.
TEST_F(SequenceWindow, TimesFollowTheTableOfTimesWhichTheReportTakesToo) {
  WorkTimes times;
  for (const WorkTimeRow& row : workTimeRows()) times.*row.value = 0.0;
  times.largeAbove = 100.0;
  times.twoHandsAbove = times.aidAbove = 1000.0;
  times.fetch = 1.0;
  ASSERT_TRUE(saveWorkTimes(times, file("second.json").toStdString()));
  expectGood(runOnStand(QStringLiteral("plan-sequence all\ntimes 2\nopen-times %1\nexpect-times sum 10.0\n"
                                       "set-time fetch_s 2.5\nexpect-times sum 25.0\n"
                                       // A value that is refused changes nothing.
                                       "set-time fetch_s -1\nset-time fetch_s soon\nexpect-time fetch_s 2.5\n"
                                       "expect-times sum 25.0\nexpect-times stations 2\n"
                                       "save-times %2\nreport-sequence %3\n")
                            .arg(file("second.json"), file("edited.json"), file("stand.html"))));
  times.fetch = 2.5;
  const auto saved = readWorkTimes(file("edited.json").toStdString());
  ASSERT_TRUE(saved) << toString(saved.error());
  EXPECT_EQ(*saved, times);
  EXPECT_TRUE(content("stand.html").contains("25.0 s"));
  EXPECT_TRUE(content("stand.html").contains("values were edited"));
}

TEST_F(SequenceWindow, WhatWasFoundIsKeptWhenPlanningIsStoppedAndGoesOn) {
  expectGood(runOnStand(
      QStringLiteral("plan-sequence 4\nexpect-sequence end interrupted\nexpect-sequence steps 4\nexport-sequence %1\n"
                     "action sequence.resume\nexpect-sequence end complete\nexpect-sequence steps 10\n"
                     "open-sequence %1\nexpect-sequence end interrupted\naction sequence.resume\n"
                     "expect-sequence steps 10\n")
          .arg(file("begun.json"))));
}

/// The stand is moved away from the parts on it, so steps that state an allowance or a clearance of both are refuted.
TEST_F(SequenceWindow, APlanIsProvedAgainWhenItIsOpenedAndWhenTheProductIsRearranged) {
  expectGood(runOnStand(QStringLiteral("plan-sequence all\nexport-sequence %1\nopen-sequence %1\n"
                                       "expect-sequence proved 10\nexpect-sequence refuted 0\n"
                                       "place stand 0,0,1 0,0,0\nexpect-sequence proved 8\n"
                                       "expect-sequence refuted 2\n"
                                       "save %3\nopen %2\nexpect-sequence end none\n"
                                       "open %3\nexpect-sequence end complete\nexpect-sequence proved 8\n")
                            .arg(file("plan.json"), kSource + QStringLiteral("/samples/sliding-plane/scenario.json"),
                                 file("stand.json"))));
}

TEST_F(SequenceWindow, ThePlanOfTheCommandLineIsThatOfTheWindow) {
  const QString stand = kSource + QStringLiteral("/samples/roller-stand/scenario.json");
  const auto commandLine = [](const QStringList& words) {
    QProcess process;
    process.start(QString::fromStdString(programDirectory() + "/glissade-cli"), words);
    EXPECT_TRUE(process.waitForFinished(60000));
    return process.exitCode();
  };
  ASSERT_EQ(commandLine({QStringLiteral("sequence"), stand, QStringLiteral("--out"), file("cli.json")}), 0);
  expectGood(runOnStand(QStringLiteral("open-sequence %1\nexpect-sequence proved 10\nplan-sequence all\n"
                                       "export-sequence %2\n")
                            .arg(file("cli.json"), file("window.json"))));
  EXPECT_EQ(commandLine({QStringLiteral("check"), stand, file("window.json")}), 0);
}

/// A statement of the opened plan itself is a condition, as on the command line.
TEST_F(SequenceWindow, WordsOfAPlanThatIsOpenedAreConditions) {
  expectGood(runOnStand(
      QStringLiteral("plan-sequence all\nexpect-sequence conditions 0\nexport-sequence %1\n").arg(file("plan.json"))));
  nlohmann::json plan = nlohmann::json::parse(content("plan.json").toStdString());
  plan.erase("checksum");
  nlohmann::json& motion = plan["steps"][0]["motions"][0];
  motion["certificate"]["status"] = "not_certified";
  motion["joints"] = {{{"kind", "flexible"}, {"body", motion["bodies"][0]}, {"others", nlohmann::json::array()}}};
  plan["certified"] = false;
  std::ofstream(file("words.json").toStdString()) << plan;
  expectGood(runOnStand(QStringLiteral("open-sequence %1\nexpect-sequence conditions 1\n").arg(file("words.json"))));
}

TEST_F(SequenceWindow, WhatStaysIsUndoneAndKeptByTheScenario) {
  expectGood(
      runOnStand(QStringLiteral("select body stand/bar\naction sequence.stays\nplan-sequence 1\nexport-sequence %1\n"
                                "action edit.undo\naction sequence.plan\nexpect-sequence end complete\n")
                     .arg(file("bar.json"))));
  EXPECT_TRUE(content("bar.json").simplified().contains("\"staying\": [ \"stand/bar\" ]"));
}

TEST_F(SequenceWindow, APersonMovesLocksAndForbidsStepsAndTakesItBack) {
  expectGood(runOnStand(
      QStringLiteral(
          "action sequence.assembly-order\nplan-sequence all\nmove-step 1 3\nexpect-row 3 bar\nexpect-row 3 "
          "placed\nexpect-sequence proved 10\nexpect-row 4 cap_right\n"
          "show-step 2\naction sequence.lock\nexpect-row 2 locked\nexpect-row 3 placed\n"
          "action sequence.step-down\nexpect-row 3 locked\nexpect-row 2 bar\nexpect-sequence proved 10\n"
          "export-sequence %1\n"
          // The screw holds the cap: the order stays.
          "action sequence.step-down\nexpect-log clamps\nexpect-row 3 locked\nexpect-row 4 cap_right\n"
          "expect-sequence end complete\naction edit.undo\nexpect-row 2 locked\naction edit.undo\n"
          "action edit.undo\nexpect-row 1 bar\n"
          "expect-sequence end complete\naction edit.redo\nexpect-row 3 bar\naction edit.undo\n"
          "show-step 7\nexpect-row 7 up\nforbid-direction +z\nexpect-sequence end complete\n"
          "select-steps 1 2\naction sequence.keep-order\nexpect-sequence steps 10\nset-cost few-tools\n"
          // The document forbids +z. A step of the opened plan leaves so.
          "expect-sequence steps 10\nsave %2\nopen-sequence %1\nexpect-sequence proved 9\nexpect-row 3 locked\n")
          .arg(file("plan.json"), file("demands.json"))));
  EXPECT_TRUE(content("demands.json").contains("\"forbidden\""));
  EXPECT_TRUE(content("demands.json").contains("few-tools"));
  EXPECT_TRUE(content("plan.json").contains("\"locked\": true"));
}

TEST_F(SequenceWindow, AStepIsMovedByHandAndItsPathComesBack) {
  const QString turn = kSource + QStringLiteral("/samples/interlocked/turn.json");
  expectGood(run(turn, QStringLiteral("plan-sequence all\nexpect-sequence steps 1\nshow-step 1\n"
                                      "action sequence.by-hand\nexpect-sequence end none\naction sequence.leave-hand\n"
                                      "expect-sequence steps 1\nshow-step 1\naction sequence.by-hand\n"
                                      "action run.start\nwait solved 20000\nsteps 1\n"
                                      "expect-sequence end complete\nexport-sequence %1\n"
                                      "action edit.undo\nexpect-row 1 certified\n"
                                      "action sequence.plan\nexpect-sequence steps 1\n")
                           .arg(file("hand.json"))));
  // No person steered the run.
  EXPECT_FALSE(content("hand.json").contains("\"method\": \"by hand\""));
  EXPECT_TRUE(content("hand.json").contains("\"method\": \"by-hand\""));
  // The links of a URDF move as one body.
  expectGood(
      runOnStand(QStringLiteral("plan-sequence all\nshow-step 7\naction sequence.by-hand\nexpect-log alone\n"
                                "expect-sequence steps 10\n")));
}

TEST_F(SequenceWindow, WhatIsSavedWhileAStepIsMovedByHandIsTheWholeProduct) {
  const QString turn = kSource + QStringLiteral("/samples/interlocked/group.json");
  expectGood(run(turn, QStringLiteral("plan-sequence all\nsave %1\nexpect-modified no\nshow-step 1\n"
                                      "action sequence.by-hand\nexpect-modified no\nsave %2\n"
                                      "action sequence.leave-hand\nexpect-modified no\n")
                           .arg(file("before.json"), file("by-hand.json"))));
  EXPECT_EQ(content("by-hand.json"), content("before.json"));
}

/// Two blocks that leave together are moved as one.
TEST_F(SequenceWindow, AGroupIsMovedByHandAndItsPathComesBack) {
  const auto block = [](const char* id, const char* x) {
    return QStringLiteral(R"({"id": "%1", "geometry": {"box": [0.1, 0.1, 0.1]},
      "pose": {"position": [%2, 0, 0], "orientation": [0, 0, 0, 1]}})")
        .arg(QLatin1String(id), QLatin1String(x));
  };
  QFile scenario(file("group.json"));
  ASSERT_TRUE(scenario.open(QIODevice::WriteOnly));
  scenario.write(QStringLiteral(R"({"format": "glissade-scenario", "version": 1, "bodies": [
    {"id": "base", "geometry": {"box": [0.6, 0.3, 0.05]},
     "pose": {"position": [0, 0, -0.1], "orientation": [0, 0, 0, 1]}}, %1, %2],
    "object": {"id": "ball", "geometry": {"sphere": {"radius": 0.05}}},
    "start": {"position": [-0.2, 0, 0], "orientation": [0, 0, 0, 1]}, "goal": "out",
    "sequence": {"together": [["left", "right"]]}, "workspace": {"min": [-2, -2, -2], "max": [2, 2, 2]}})")
                     .arg(block("left", "0"), block("right", "0.15"))
                     .toUtf8());
  scenario.close();
  expectGood(run(file("group.json"), QStringLiteral("plan-sequence all\nexpect-sequence steps 2\nexpect-row 1 right\n"
                                                    "show-step 1\naction sequence.by-hand\n"
                                                    "expect-sequence end none\naction run.start\n"
                                                    "wait solved 20000\nsteps 1\nexpect-sequence end complete\n"
                                                    "expect-sequence steps 2\nexport-sequence %1\n")
                                         .arg(file("group-plan.json"))));
  QProcess check;
  check.start(QString::fromStdString(programDirectory() + "/glissade-cli"),
              {QStringLiteral("check"), file("group.json"), file("group-plan.json")});
  EXPECT_TRUE(check.waitForFinished(60000));
  EXPECT_EQ(check.exitCode(), 0);
  EXPECT_TRUE(content("group-plan.json").contains("\"motions\"")) << "the path is a demand";
}

TEST_F(SequenceWindow, EveryFormatIsWritten) {
  expectGood(runOnStand(QStringLiteral("plan-sequence all\nexport-sequence %1\n"
                                       "export-sequence %2\nexport-sequence %3\nexport-sequence %4\n")
                            .arg(file("plan.html"), file("plan.pdf"), file("plan.csv"), file("plan.glb"))));
  const QByteArray page = content("plan.html");
  EXPECT_EQ(page.count("<section"), 11) << "cover, parts list, start, six steps and two tasks of two";
  EXPECT_TRUE(content("plan.pdf").startsWith("%PDF"));
  EXPECT_EQ(content("plan.csv").count('\n'), 11);
  EXPECT_TRUE(content("plan.glb").startsWith("glTF"));
  QProcess raster;
  raster.start(QStringLiteral("pdftoppm"),
               {QStringLiteral("-r"), QStringLiteral("72"), QStringLiteral("-png"), QStringLiteral("-f"),
                QStringLiteral("3"), QStringLiteral("-singlefile"), file("plan.pdf"), file("page")});
  ASSERT_TRUE(raster.waitForFinished() && raster.exitCode() == 0) << "pdftoppm (poppler-utils) is not installed";
  expectLike(file("page.png"), QStringLiteral("instruction-page"));
}

TEST_F(SequenceWindow, TheReportForEngineersIsADocumentOfItsOwn) {
  expectGood(runOnStand(QStringLiteral("plan-sequence all\nreport-sequence %1\nreport-sequence %2\n")
                            .arg(file("report.html"), file("report.pdf"))));
  const QByteArray page = content("report.html");
  EXPECT_EQ(page.count("<img"), 10) << "six steps and two tasks of two, the exploded view, the graph";
  EXPECT_EQ(page.count("class=\"page\""), 11) << "parts list, six steps and two tasks of two, the times, the graph";
  EXPECT_TRUE(page.contains("Found by"));
  EXPECT_TRUE(content("report.pdf").startsWith("%PDF"));
}

TEST_F(SequenceWindow, AWorkInstructionFollowsItsTemplate) {
  const auto pages = [&](const QString& pdf) {
    QProcess info;
    info.start(QStringLiteral("pdfinfo"), {pdf});
    EXPECT_TRUE(info.waitForFinished() && info.exitCode() == 0) << "pdfinfo (poppler-utils) is not installed";
    return info.readAllStandardOutput();
  };
  QFile look(file("look.json"));
  ASSERT_TRUE(look.open(QIODevice::WriteOnly));
  look.write(R"({"format": "glissade-instruction-template", "version": 1, "company": "Muster", "language": "fr"})");
  look.close();
  expectGood(runOnStand(QStringLiteral("plan-sequence all\ninstruction-template %1\ninstruction-paper Letter\n"
                                       "export-sequence %2\nexport-sequence %3\ninstruction-template none\n"
                                       "export-sequence %4\n")
                            .arg(file("look.json"), file("fr.html"), file("letter.pdf"), file("en.html"))));
  EXPECT_TRUE(content("fr.html").contains("Suivant") && content("fr.html").contains("Muster"));
  EXPECT_TRUE(content("en.html").contains("Next") && !content("en.html").contains("Muster"));
  EXPECT_TRUE(pages(file("letter.pdf")).contains("(letter)"));
}

/// Sections, hidden bodies and the camera of the window do not change the pictures.
TEST_F(SequenceWindow, PicturesOfAWorkInstructionDoNotDependOnTheView) {
  expectGood(runOnStand(QStringLiteral("plan-sequence all\nexport-sequence %1\nsection x 0.5\naction view.top\n"
                                       "export-sequence %2\n")
                            .arg(file("one.html"), file("two.html"))));
  EXPECT_EQ(content("one.html"), content("two.html"));
}

/// The test opens the page in a browser: buttons, keys, swipes, and the 3D view if three.js is installed.
TEST_F(SequenceWindow, AWorkInstructionWorksInABrowser) {
  const QString browser = QStandardPaths::findExecutable(QStringLiteral("chromium"));
  if (browser.isEmpty()) GTEST_SKIP() << "chromium is not installed";
  expectGood(runOnStand(QStringLiteral("plan-sequence all\nexport-sequence %1\n").arg(file("page.html"))));
  QByteArray page = content("page.html");
  const QByteArray driver = R"(<script>
    var said = [], page = window.instruction;
    function key(name) { document.dispatchEvent(new KeyboardEvent('keydown', { key: name, bubbles: true })); }
    function swipe(from, to) {
      var touch = function (x) { return new Touch({ identifier: 1, target: document.body, clientX: x, clientY: 300 }); };
      document.dispatchEvent(new TouchEvent('touchstart', { touches: [touch(from)], bubbles: true }));
      document.dispatchEvent(new TouchEvent('touchend', { changedTouches: [touch(to)], bubbles: true }));
    }
    function say() { said.push(page.shown()); }
    say(); key('ArrowRight'); say(); key('End'); say(); key('Home'); say();
    swipe(600, 200); say(); swipe(200, 600); say(); swipe(400, 420); say();
    document.getElementById('next').click(); say(); document.getElementById('previous').click(); say();
    var button = document.getElementById('scene');
    if (button) { page.show(3); button.click(); }
    setTimeout(function () { document.body.setAttribute('data-said', said.join(' ') + ' frames ' + (page.frames > 0)); }, 6000);
  </script></body>)";
  page.replace("</body>", driver);
  QFile driven(file("driven.html"));
  ASSERT_TRUE(driven.open(QIODevice::WriteOnly));
  driven.write(page);
  driven.close();
  QProcess process;
  process.start(browser,
                {QStringLiteral("--headless"), QStringLiteral("--no-sandbox"), QStringLiteral("--disable-gpu"),
                 QStringLiteral("--use-gl=angle"), QStringLiteral("--use-angle=swiftshader"),
                 QStringLiteral("--enable-unsafe-swiftshader"), QStringLiteral("--user-data-dir=") + file("chromium"),
                 QStringLiteral("--virtual-time-budget=9000"), QStringLiteral("--dump-dom"),
                 QStringLiteral("file://") + file("driven.html")});
  ASSERT_TRUE(process.waitForFinished(120000)) << process.readAllStandardError().toStdString();
  const bool hasScene = page.contains("id=\"scene\"");
  const QByteArray expected = QByteArray("data-said=\"0 1 10 0 1 0 0 1 0 frames ") + (hasScene ? "true" : "false");
  const QByteArray dom = process.readAllStandardOutput();
  EXPECT_TRUE(dom.contains(expected)) << dom.mid(dom.indexOf("data-said"), 60).toStdString();
}

TEST_F(SequenceWindow, TheWorkInstructionIsInTheLanguageOfTheWindow) {
  expectGood(runOnStand(QStringLiteral("plan-sequence 2\nexport-sequence %1\n").arg(file("fr.html")),
                        {QStringLiteral("--language"), QStringLiteral("fr")}));
  EXPECT_TRUE(content("fr.html").contains("Suivant"));
}

TEST_F(SequenceWindow, AHandIsShownAtTheStepsAndTheTableSaysWhichItReaches) {
  expectGood(runOnStand(
      QStringLiteral("expect-access none\nplan-sequence all\naction access.sequence\nexpect-access %1\n"
                     "expect-row 6 reachable\nshow-step 6\nscreenshot %2\naction access.show\nscreenshot %3\n"
                     "action access.show\naction access.next\naction access.small\nexpect-access %1\n")
          .arg(QString::number(kReached), file("hand.png"), file("no-hand.png"))));
  EXPECT_GT(difference(QImage(file("hand.png")), QImage(file("no-hand.png"))).share, 0.01);
  expectLike(file("hand.png"), QStringLiteral("sequence-access"));
}

TEST_F(SequenceWindow, AHandIsAskedAlongThePathOfTheObject) {
  const char* script =
      "expect-access none\nselect-operator expert\naction run.start\nwait solved 20000\naction access.path\n"
      "expect-access no_grip\naction access.next\n";
  expectGood(run(QStringLiteral("environment-1"), QLatin1String(script)));
}

TEST_F(SequenceWindow, WrongCommandsAndFilesAreErrors) {
  const QString none = file("none.json");
  for (const QString& script :
       {QStringLiteral("open-sequence %1\n").arg(none), QStringLiteral("export-sequence %1\n").arg(none),
        QStringLiteral("plan-sequence all\nexport-sequence %1.doc\n").arg(none),
        QStringLiteral("plan-sequence all\nreport-sequence %1.csv\n").arg(none),
        QStringLiteral("report-sequence %1.html\n").arg(none), QStringLiteral("instruction-paper A3\n"),
        QStringLiteral("instruction-template %1\n").arg(none), QStringLiteral("show-step 1\n"),
        QStringLiteral("plan-sequence some\n"), QStringLiteral("explode 2\n"),
        QStringLiteral("expect-sequence moon 1\n"), QStringLiteral("plan-sequence all\nexpect-sequence steps 3\n")}) {
    EXPECT_NE(runOnStand(script).exitCode, 0) << script.toStdString();
  }
}

TEST_F(SequenceWindow, ThePanelAndTheExplodedViewLookAsTheyDid) {
  expectGood(runOnStand(QStringLiteral("plan-sequence all\nshow-step 6\nscreenshot %1\naction sequence.show-product\n"
                                       "explode 1\naction view.fit\nscreenshot %2\n")
                            .arg(file("step.png"), file("exploded.png"))));
  expectLike(file("step.png"), QStringLiteral("sequence-step"));
  expectLike(file("exploded.png"), QStringLiteral("sequence-exploded"));
}

}  // namespace
