// Scripts use the editor of semantic attributes, the layers of the environment model and the table of topological steps
// in the whole window, as a person would.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "tests/app/window_fixture.h"

namespace {

using namespace glissade::test;

class EnvironmentWindow : public WindowTest {
 protected:
  /// Copies a sample's folder so that it may be written to, and returns the scenario file in it.
  QString copyOf(const QString& sample, const QString& scenario) {
    const QDir from(kSource + QStringLiteral("/samples/") + sample);
    const QDir to(folder.filePath(sample));
    EXPECT_TRUE(QDir().mkpath(to.path()));
    for (const QString& name : from.entryList(QDir::Files)) QFile::copy(from.filePath(name), to.filePath(name));
    return to.filePath(scenario);
  }

  void expectGood(const WindowResult& result) { EXPECT_EQ(result.exitCode, 0) << result.errors.toStdString(); }
};

TEST_F(EnvironmentWindow, AComplexityChangesTheCoarsePathIsUndoneSavedAndThereAgain) {
  const QString scenario = copyOf(QStringLiteral("shape-game"), QStringLiteral("tight-circle.json"));
  const QString saved = QFileInfo(scenario).dir().filePath(QStringLiteral("saved.json"));
  expectGood(run(scenario, QStringLiteral("action layer.places\n"
                                          "click 448 427\n"  // the narrow passage P4
                                          "expect-attribute complexity 3\n"
                                          "expect-way P1,P9,P2,P5,P3\n"
                                          "select place P9\n"
                                          "attribute complexity 40\n"
                                          "expect-way P1,P7,P2,P5,P3\n"
                                          "action edit.undo\n"
                                          "expect-attribute complexity 4\n"
                                          "expect-way P1,P9,P2,P5,P3\n"
                                          "action edit.redo\n"
                                          "save %1\n"
                                          "open %1\n"
                                          "select place P9\n"
                                          "expect-attribute complexity 40\n"
                                          "expect-way P1,P7,P2,P5,P3\n"
                                          "attribute complexity -\n"
                                          "expect-attribute complexity 4\n")
                               .arg(saved)));
}

TEST_F(EnvironmentWindow, APlaceIsForbiddenWhileTheRunGoesOn) {
  expectGood(run(QStringLiteral("shape-game/tight-circle.json").prepend(kSource + QStringLiteral("/samples/")),
                 QStringLiteral("action run.start\nsteps 1\nselect place P9\naction place.forbid\n"
                                "expect-attribute forbidden yes\nsteps 2\nexpect-way P1,P7,P2,P5,P3\n"
                                "wait solved 20000\nexpect-way P1,P7,P2,P5,P3\n")));
}

TEST_F(EnvironmentWindow, TheStepThatIsHighlightedIsTheOneThatIsForbidden) {
  // The plan loses P9. No other row takes its highlight, and P9 stays selected.
  const QString pentagon = kSource + QStringLiteral("/samples/shape-game/tight-pentagon.json");
  expectGood(run(pentagon, QStringLiteral("select-strategy gts2\naction run.start\nsteps 2\nselect step 2\n"
                                          "expect-step P9\naction place.forbid\nexpect-attribute forbidden yes\n"
                                          "steps 2\nexpect-step -\naction edit.undo\nsteps 2\n"
                                          "select step 2\nexpect-step P9\n")));
  // Another selection leaves the step. A click on the step's row selects its place again.
  expectGood(run(pentagon, QStringLiteral("select step 2\nexpect-step P9\nselect place P1\nexpect-step -\n"
                                          "select step 2\nselect step 2\naction place.forbid\n"
                                          "select place P9\nexpect-attribute forbidden yes\n")));
}

TEST_F(EnvironmentWindow, ARunsPlanIsShownOnlyWhereItBelongs) {
  const QString teaching = QStringLiteral("teaching");
  // With another strategy the panel shows that strategy's preview, not the plan of the first one.
  expectGood(run(teaching, QStringLiteral("select-strategy gts\naction run.start\nwait solved 20000\n"
                                          "expect-plan tried\nselect-strategy gt\nexpect-plan preview\n"
                                          "select-strategy gts\nexpect-plan tried\nselect-strategy birrt\n"
                                          "expect-plan none\n")));
  // A plan of other places is not shown, because its place numbers would name the wrong places.
  expectGood(run(QStringLiteral("environment-1"),
                 QStringLiteral("select-strategy gts2\naction environment.build\naction run.start\nsteps 30\n"
                                "expect-plan tried\nidentify watershed\nexpect-plan preview\n"
                                "select step 1\nselect step 2\nidentify region-growing\nexpect-plan tried\n")));
}

TEST_F(EnvironmentWindow, AttributesOfOnesOwnAreKeptAndBadValuesRefused) {
  const QString scenario = copyOf(QStringLiteral("teaching"), QStringLiteral("scenario.json"));
  expectGood(run(scenario, QStringLiteral("define fragile bool place\nselect place P2\nattribute fragile yes\n"
                                          "select body O1\nattribute shape wall\nsave %1\nopen %1\n"
                                          "select place P2\nexpect-attribute fragile yes\n"
                                          "select body O1\nexpect-attribute shape wall\n")
                               .arg(scenario)));
  const WindowResult refused = run(scenario, QStringLiteral("select place P2\nattribute compatibility 2\n"));
  EXPECT_EQ(refused.exitCode, 3);
  EXPECT_TRUE(refused.errors.contains(QStringLiteral("line 2: 'compatibility' is 2, which is out of range")))
      << refused.errors.toStdString();
}

TEST_F(EnvironmentWindow, AnEditStaysWhereABodyIsSetStaticOnItsPlace) {
  expectGood(run(QStringLiteral("teaching"), QStringLiteral("select place P3\nattribute forbidden yes\n"
                                                            "select body O5\nattribute mobility static\n"
                                                            "select place P5\nexpect-attribute forbidden yes\n")));
}

TEST_F(EnvironmentWindow, WhatIsTypedIsSavedAndUndoneWithoutEnter) {
  const QString scenario = copyOf(QStringLiteral("teaching"), QStringLiteral("scenario.json"));
  expectGood(run(scenario, QStringLiteral("select place P3\ntype shape round\naction file.save\nopen %1\n"
                                          "select place P3\nexpect-attribute shape round\n"
                                          "attribute forbidden yes\ntype shape er\naction edit.undo\n"
                                          "expect-attribute shape round\nexpect-attribute forbidden yes\n")
                               .arg(scenario)));
}

TEST_F(EnvironmentWindow, ABodyThatIsHiddenIsNotDrawnAndComesBack) {
  const QString all = folder.filePath(QStringLiteral("all.png"));
  const QString fewer = folder.filePath(QStringLiteral("fewer.png"));
  const QString again = folder.filePath(QStringLiteral("again.png"));
  const WindowResult result =
      run(QStringLiteral("teaching"), QStringLiteral("screenshot %1\nshow-body O2 no\nscreenshot %2\n"
                                                     "action body.show-all\nscreenshot %3\nselect body O1\n"
                                                     "action body.isolate\naction body.hide\n")
                                          .arg(all, fewer, again));
  expectGood(result);
  EXPECT_GT(difference(QImage(all), QImage(fewer)).share, 0.001);
  EXPECT_EQ(difference(QImage(all), QImage(again)).share, 0.0);
  EXPECT_EQ(run(QStringLiteral("teaching"), QStringLiteral("show-body O99 no\n")).exitCode, 3);
}

TEST_F(EnvironmentWindow, ABodyThatIsSetMobileShapesNoPlaceAnyMore) {
  // Without O2 the two walls and the slot are gone, so the way leads straight up.
  expectGood(run(QStringLiteral("teaching"), QStringLiteral("expect-way P2,P5,P3,P4,P1\nselect body O2\n"
                                                            "attribute mobility mobile\naction edit.undo\n"
                                                            "expect-way P2,P5,P3,P4,P1\n")));
}

TEST_F(EnvironmentWindow, AMilestoneIsDraggedPassedThroughAndUndoneInOneStep) {
  const QString scenario = copyOf(QStringLiteral("teaching"), QStringLiteral("scenario.json"));
  const auto milestonesAfter = [&](const QString& script) {
    const QString saved = QFileInfo(scenario).dir().filePath(QStringLiteral("saved.json"));
    expectGood(run(scenario, script + QStringLiteral("save %1\n").arg(saved)));
    QFile file(saved);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return QJsonDocument::fromJson(file.readAll()).object()[QStringLiteral("milestones")].toArray().size();
  };
  const QString drag = QStringLiteral("action run.start\nwait solved 20000\ndrag 408 315 422 290\n");
  EXPECT_EQ(milestonesAfter(drag + QStringLiteral("action run.start\nwait solved 20000\n")), 1);
  EXPECT_EQ(milestonesAfter(drag + QStringLiteral("action edit.undo\n")), 0);
  // The other milestones of the run stay and can be moved next.
  EXPECT_EQ(milestonesAfter(drag + QStringLiteral("drag 146 269 161 257\n")), 2);
  // A drag into the wall is refused and changes nothing.
  EXPECT_EQ(milestonesAfter(QStringLiteral("action run.start\nwait solved 20000\ndrag 408 315 345 340\n")), 0);
}

TEST_F(EnvironmentWindow, PicturesOfTheEditorTheStepsAndTheLayers) {
  const QString base = folder.filePath(QStringLiteral("shape"));
  const QString sample = kSource + QStringLiteral("/samples/shape-game/tight-star.json");
  expectGood(run(sample, QStringLiteral("action layer.places\nselect place P9\nscreenshot %1-editor.png\n"
                                        "action run.start\nwait solved 20000\nselect step 3\n"
                                        "action layer.region\naction layer.graph\nscreenshot %1-steps.png\n")
                             .arg(base)));
  expectLike(base + QStringLiteral("-editor.png"), QStringLiteral("shape-game-editor"));
  expectLike(base + QStringLiteral("-steps.png"), QStringLiteral("shape-game-steps"));
  expectGood(
      run(sample,
          QStringLiteral("action layer.free-cells\naction layer.mobile-cells\naction layer.borders\n"
                         "action run.start\nwait solved 20000\nscreenshot %1-dark.png\n")
              .arg(base),
          {QStringLiteral("--theme"), QStringLiteral("dark"), QStringLiteral("--size"), QStringLiteral("1920x1080")}));
  expectLike(base + QStringLiteral("-dark.png"), QStringLiteral("shape-game-dark"));
}

}  // namespace
