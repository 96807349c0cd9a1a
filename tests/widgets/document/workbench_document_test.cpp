#include "widgets/document/workbench_document.h"
#include "tests/engine/files/some_plan.h"
#include "tests/engine/support/directories.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QtTest/QTest>

#include <algorithm>

#include "engine/files/assembly_edits.h"
#include "engine/files/scenario_io.h"

namespace glissade {
namespace {

WorkbenchDocument::ScenarioChange becomes(const Scenario& after) {
  return [after](Scenario& scenario) {
    scenario = after;
    return Outcome(Done{});
  };
}

class WorkbenchDocumentTest : public testing::Test {
 protected:
  WorkbenchDocumentTest() {
    auto loaded = loadScenario(test::sourceDirectory() + "/samples/teaching/scenario.json");
    const auto scenario = std::make_shared<const LoadedScenario>(std::move(*loaded));
    document.open(scenario);
  }

  /// Waits until all edits are made.
  ::testing::AssertionResult arranged() {
    return QTest::qWaitFor([this] { return !document.isArranging(); }, 20'000) ? ::testing::AssertionSuccess()
                                                                               : ::testing::AssertionFailure();
  }
  Vector3 wallAt() const { return document.scenario()->obstacles.front().X_WB.position; }

  std::string text() const { return writeScenario(document.current()); }

  const AssemblyItem wall{AssemblyItem::Kind::Body, "O1"};
  WorkbenchDocument document;
  SemanticDocument& semantics = document.semantics();
};

TEST_F(WorkbenchDocumentTest, AMoveIsOneStepBackAndForth) {
  const std::string before = text();
  int rearranged = 0;
  QObject::connect(&document, &WorkbenchDocument::changed,
                   [&](Changes what) { rearranged += what & Change::Arrangement ? 1 : 0; });
  ASSERT_TRUE(document.place(wall, Pose::translation({0.1, 0.2, 0.3})).ok());
  const std::string after = text();
  EXPECT_NE(after, before);
  EXPECT_EQ(document.scenario()->obstacles.front().X_WB.position, Vector3(0.1, 0.2, 0.3));
  document.undoStack().undo();
  EXPECT_EQ(text(), before);
  document.undoStack().redo();
  EXPECT_EQ(text(), after);
  EXPECT_EQ(rearranged, 3);
  ASSERT_TRUE(document.place(wall, Pose::translation({0.1, 0.2, 0.3})).ok());
  EXPECT_EQ(rearranged, 3) << "nothing was moved";
}

TEST_F(WorkbenchDocumentTest, AScenarioFromAFileIsNotModifiedWhateverWasOpenBefore) {
  const ScenarioPtr saved = document.scenario();
  EXPECT_FALSE(document.isModified());
  auto unsaved = std::make_shared<LoadedScenario>(*saved);
  unsaved->file.clear();
  document.open(unsaved);
  EXPECT_FALSE(document.isModified()) << "to look at a product is no edit";
  ASSERT_TRUE(document.place(wall, Pose::translation({0.1, 0.2, 0.3})).ok());
  EXPECT_TRUE(document.isModified());
  document.open(saved);
  EXPECT_FALSE(document.isModified());
}

TEST_F(WorkbenchDocumentTest, StepsOfOneNumberAreOneStepBack) {
  const std::string before = text();
  for (const double x : {0.1, 0.2, 0.3}) {
    ASSERT_TRUE(document.place(wall, Pose::translation({x, 0, 0}), QStringLiteral("x")).ok());
  }
  EXPECT_EQ(document.undoStack().count(), 1);
  document.undoStack().undo();
  EXPECT_EQ(text(), before);
}

TEST_F(WorkbenchDocumentTest, ABodyComesBackWithItsAttributesInAnyOrderOfEdits) {
  SemanticSelection selected;
  selected.bodies.insert(QStringLiteral("O1"));
  ASSERT_TRUE(semantics.setAttribute(selected, "shape", AttributeValue(std::string("wall"))).ok());
  ASSERT_TRUE(document.place(wall, Pose::translation({0, 0, 1})).ok());
  semantics.select(selected);
  Scenario without = document.current();
  ASSERT_TRUE(removeBody("O1", without).ok());
  ASSERT_TRUE(document.edit(QStringLiteral("Remove"), becomes(without)).ok());
  EXPECT_EQ(semantics.edits().bodies.count("O1"), 0U);
  EXPECT_TRUE(semantics.selection().bodies.isEmpty());
  document.undoStack().undo();
  EXPECT_EQ(semantics.bodyValue(QStringLiteral("O1"), "shape").value, AttributeValue(std::string("wall")));
  EXPECT_EQ(document.scenario()->obstacles.front().X_WB.position, Vector3(0, 0, 1));
  document.undoStack().undo();
  document.undoStack().undo();
  EXPECT_FALSE(document.undoStack().canUndo());
  EXPECT_EQ(semantics.edits().bodies.count("O1"), 0U);
}

TEST_F(WorkbenchDocumentTest, IsSavedWhileTheFileSaysTheSame) {
  EXPECT_TRUE(document.isProblemSaved());
  ASSERT_TRUE(document.place(wall, Pose::translation({0, 0, 1})).ok());
  EXPECT_FALSE(document.isProblemSaved());
  document.undoStack().undo();
  EXPECT_TRUE(document.isProblemSaved());
}

TEST_F(WorkbenchDocumentTest, WhatCannotBeLoadedIsRefusedAndChangesNothing) {
  const std::string before = text();
  Scenario broken = document.current();
  broken.assets.push_back({"gone", "gone.stl", "", 1.0, UpAxis::Z});
  broken.object.first().geometry = MeshGeometry{"gone"};
  const Outcome outcome = document.edit(QStringLiteral("Break"), becomes(broken));
  ASSERT_FALSE(outcome.ok());
  EXPECT_NE(outcome.error().file.find("gone.stl"), std::string::npos);
  EXPECT_EQ(text(), before);
  EXPECT_FALSE(document.undoStack().canUndo());
}

/// Records each announcement with its phase: "view 255".
void record(WorkbenchDocument& document, std::vector<std::string>& rounds) {
  const auto note = [&rounds](const char* phase) {
    return [&rounds, phase](Changes what) { rounds.push_back(phase + std::string(" ") + std::to_string(int(what))); };
  };
  // The order of the connections differs from that of the phases.
  QObject::connect(&document, &WorkbenchDocument::changed, &document, note("panels"));
  QObject::connect(&document, &WorkbenchDocument::changedForSession, &document, note("session"));
  QObject::connect(&document, &WorkbenchDocument::changedForView, &document, note("view"));
}

TEST_F(WorkbenchDocumentTest, EveryChangeIsOneRoundOfThreePhases) {
  std::vector<std::string> rounds;
  record(document, rounds);
  document.open(ScenarioPtr(document.scenario()));
  EXPECT_EQ(rounds, (std::vector<std::string>{"view 2047", "session 2047", "panels 2047"}));
  rounds.clear();
  Scenario without = document.current();
  without.attributeDefinitions.clear();
  without.places.clear();
  without.milestones.clear();
  ASSERT_TRUE(removeBody("O1", without).ok());
  const bool editsChange = !(semanticEditsOf(without) == semantics.edits());
  ASSERT_TRUE(document.edit(QStringLiteral("Remove"), becomes(without)).ok());
  const int what = int(Change::Arrangement) | (editsChange ? int(Change::Semantics) : 0);
  const std::string flags = std::to_string(what);
  ASSERT_GE(rounds.size(), 3U);
  EXPECT_EQ(rounds[0], "view " + flags);
  EXPECT_EQ(rounds[1], "session " + flags);
  EXPECT_EQ(rounds[2], "panels " + flags);
}

TEST_F(WorkbenchDocumentTest, AChangeMadeInARoundHasARoundOfItsOwn) {
  std::vector<std::string> rounds;
  QObject::connect(&document, &WorkbenchDocument::changed, &document, [this](Changes what) {
    EnvironmentOptions options = document.options();
    options.identifier = "watershed";
    if (what & Change::Arrangement) document.setOptions(options);
  });
  record(document, rounds);
  ASSERT_TRUE(document.place(wall, Pose::translation({0, 0, 1})).ok());
  const std::vector<std::string> first{"view 2", "session 2", "panels 2", "view 16", "session 16", "panels 16"};
  ASSERT_GE(rounds.size(), first.size());
  EXPECT_TRUE(std::equal(first.begin(), first.end(), rounds.begin()));
}

TEST_F(WorkbenchDocumentTest, TheSameAgainIsNotAnnounced) {
  std::vector<std::string> rounds;
  record(document, rounds);
  document.setSettings(document.settings());
  document.setOptions(document.options());
  document.setResults(document.results());
  EXPECT_TRUE(rounds.empty());
  RunSettings settings = document.settings();
  ++settings.seed;
  document.setSettings(settings);
  EXPECT_EQ(rounds, (std::vector<std::string>{"view 32", "session 32", "panels 32"}));
  EXPECT_FALSE(document.isModified()) << "seeds are tried out";
  settings.strategy = "birrt";
  document.setSettings(settings);
  EXPECT_TRUE(document.isModified());
}

TEST_F(WorkbenchDocumentTest, WhatWasSavedIsOpenedTheSame) {
  const QTemporaryDir folder;
  const std::string file = folder.filePath(QStringLiteral("saved.json")).toStdString();
  ASSERT_TRUE(document.place(wall, Pose::translation({0, 0, 1})).ok());
  RunSettings settings = document.settings();
  settings.seed = 77;
  document.setSettings(settings);
  EXPECT_TRUE(document.isModified());
  const Scenario content = document.contentFor(file);
  ASSERT_TRUE(saveScenario(content, file).ok());
  document.noteSaved(file, content);
  EXPECT_FALSE(document.isModified());
  EXPECT_EQ(document.scenario()->file, file);
  const auto loaded = loadScenario(file);
  ASSERT_TRUE(loaded.ok());
  EXPECT_EQ(loaded->scenario.seed, 77U);
  EXPECT_EQ(loaded->obstacles.front().X_WB.position, Vector3(0, 0, 1));
  document.undoStack().undo();
  EXPECT_TRUE(document.isModified());
}

TEST_F(WorkbenchDocumentTest, InTheBackgroundEditsAreMadeInTheirOrderOfWhatTheOnesBeforeLeft) {
  document.setAtOnce(false);
  const Vector3 before = wallAt();
  ASSERT_TRUE(document.place(wall, Pose::translation({0, 0, 1})).ok());
  EXPECT_TRUE(document.isArranging());
  EXPECT_TRUE(document.isModified());
  EXPECT_EQ(wallAt(), before) << "the window does not wait";
  const Pose start = Pose::translation(document.scenario()->problem.start.position + Vector3(0.001, 0, 0));
  ASSERT_TRUE(document.place({AssemblyItem::Kind::Start, {}}, start).ok());
  bool asked = false;
  document.whenArranged([&] { asked = wallAt() == Vector3(0, 0, 1); });
  EXPECT_FALSE(asked);
  ASSERT_TRUE(arranged());
  EXPECT_TRUE(asked);
  EXPECT_EQ(wallAt(), Vector3(0, 0, 1));
  EXPECT_EQ(document.scenario()->problem.start.position, start.position);
  EXPECT_EQ(document.undoStack().count(), 2);
  document.undo();
  document.undo();
  ASSERT_TRUE(arranged());
  EXPECT_EQ(wallAt(), before);
  document.redo();
  ASSERT_TRUE(arranged());
  EXPECT_EQ(wallAt(), Vector3(0, 0, 1));
}

/// A scenario as it is opened if finding its fits takes long.
ScenarioPtr withFitsToFind() {
  auto loaded = loadScenario(test::sourceDirectory() + "/samples/teaching/scenario.json");
  loaded->scenario.fits.on = true;
  loaded->fitsPending = true;
  return std::make_shared<const LoadedScenario>(std::move(*loaded));
}

TEST_F(WorkbenchDocumentTest, FitsThatWereLeftForLaterAreFoundInTheBackground) {
  document.setAtOnce(false);
  int rearranged = 0;
  QObject::connect(&document, &WorkbenchDocument::changed, [&](Changes what) {
    rearranged += what & Change::Arrangement && !(what & Change::Scenario) ? 1 : 0;
  });
  document.open(withFitsToFind());
  document.noteSaved("opened.json", document.current());
  EXPECT_TRUE(document.scenario()->fitsPending);
  EXPECT_FALSE(document.isModified()) << "what is found is no edit";
  bool startedWithFits = false;
  document.whenArranged([&] { startedWithFits = !document.scenario()->fitsPending; });
  EXPECT_FALSE(startedWithFits);
  ASSERT_TRUE(arranged());
  EXPECT_TRUE(startedWithFits);
  EXPECT_EQ(rearranged, 1);
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(WorkbenchDocumentTest, WhereEditsAreDoneAtOnceFitsAreFoundWhenTheyAreNeeded) {
  document.open(withFitsToFind());
  EXPECT_TRUE(document.scenario()->fitsPending);
  bool startedWithFits = false;
  document.whenArranged([&] { startedWithFits = !document.scenario()->fitsPending; });
  EXPECT_TRUE(startedWithFits);
}

TEST_F(WorkbenchDocumentTest, NothingBeginsWhereTheFitsCannotBeFound) {
  auto wrong = std::make_shared<LoadedScenario>(*withFitsToFind());
  wrong->scenario.fits.pairs.push_back({"nobody", wrong->object.id, {}, 0.001, false});
  document.open(wrong);
  int failures = 0;
  QObject::connect(&document, &WorkbenchDocument::editFailed,
                   [&](const std::optional<Diagnostic>& why) { failures += why ? 1 : 0; });
  bool begun = false;
  document.whenArranged([&begun] { begun = true; });
  EXPECT_FALSE(begun);
  EXPECT_EQ(failures, 1);
}

TEST_F(WorkbenchDocumentTest, NumbersTypedWhileAnEditIsMadeAreOneEditAfterIt) {
  document.setAtOnce(false);
  for (const double x : {0.1, 0.2, 0.3, 0.4}) {
    ASSERT_TRUE(document.place(wall, Pose::translation({x, 0, 0}), QStringLiteral("x")).ok());
  }
  int rearranged = 0;
  QObject::connect(&document, &WorkbenchDocument::changed,
                   [&](Changes what) { rearranged += what & Change::Arrangement ? 1 : 0; });
  ASSERT_TRUE(arranged());
  EXPECT_EQ(wallAt().x(), 0.4);
  EXPECT_EQ(rearranged, 2);
  EXPECT_EQ(document.undoStack().count(), 1);
}

TEST_F(WorkbenchDocumentTest, SemanticEditsMadeWhileBodiesAreArrangedStay) {
  document.setAtOnce(false);
  SemanticSelection selected;
  selected.bodies.insert(QStringLiteral("O1"));
  ASSERT_TRUE(document.place(wall, Pose::translation({0, 0, 1})).ok());
  ASSERT_TRUE(semantics.setAttribute(selected, "shape", AttributeValue(std::string("wall"))).ok());
  ASSERT_TRUE(arranged());
  EXPECT_EQ(semantics.bodyValue(QStringLiteral("O1"), "shape").value, AttributeValue(std::string("wall")));
  EXPECT_EQ(wallAt(), Vector3(0, 0, 1));
}

TEST_F(WorkbenchDocumentTest, ACancelledOrRefusedEditChangesNothing) {
  document.setAtOnce(false);
  const std::string before = text();
  std::vector<bool> failures;  // whether a failure has a reason
  QObject::connect(&document, &WorkbenchDocument::editFailed,
                   [&](const std::optional<Diagnostic>& why) { failures.push_back(why.has_value()); });
  ASSERT_TRUE(document.place(wall, Pose::translation({0, 0, 1})).ok());
  document.cancelEdits();
  EXPECT_FALSE(document.isArranging());
  Scenario broken = document.current();
  broken.assets.push_back({"gone", "gone.stl", "", 1.0, UpAxis::Z});
  broken.object.first().geometry = MeshGeometry{"gone"};
  EXPECT_TRUE(document.edit(QStringLiteral("Break"), becomes(broken)).ok());
  ASSERT_TRUE(arranged());
  EXPECT_EQ(failures, (std::vector<bool>{false, true}));
  EXPECT_EQ(text(), before);
  EXPECT_FALSE(document.undoStack().canUndo());
}

TEST_F(WorkbenchDocumentTest, APathThatARunFoundIsUnsavedUntilItIsKeptOrExported) {
  auto path = std::make_shared<Path>();
  path->points = {{document.scenario()->problem.start}, {Pose::translation({1, 2, 3})}};
  path->certificate.tolerance = 1e-6;
  document.setResults({path, nullptr, {}, false});
  EXPECT_FALSE(document.hasUnkeptPath()) << "a path that was given has a file of its own";
  path = std::make_shared<Path>(*path);
  document.setResults({path, nullptr, {"gts", 3}, false});
  EXPECT_TRUE(document.hasUnkeptPath());
  EXPECT_FALSE(document.isModified()) << "a result is no edit";
  ASSERT_EQ(document.contentFor("a.json").paths.size(), 1U) << "saving never loses it";
  EXPECT_TRUE(document.paths().paths().empty());

  document.noteExported(path);
  EXPECT_FALSE(document.hasUnkeptPath());
  const auto another = std::make_shared<const Path>(*path);
  document.setResults({another, nullptr, {"gts", 3}, false});
  EXPECT_TRUE(document.hasUnkeptPath());
  document.keepResult();
  document.keepResult();
  EXPECT_FALSE(document.hasUnkeptPath());
  ASSERT_EQ(document.paths().paths().size(), 1U);
  EXPECT_EQ(document.paths().paths()[0]->provenance.seed, 3U);
  EXPECT_TRUE(document.isModified());
  const Scenario saved = document.contentFor("a.json");
  EXPECT_EQ(saved.paths.size(), 1U);
  document.noteSaved("a.json", saved);
  EXPECT_FALSE(document.isModified());
  document.undo();
  EXPECT_TRUE(document.hasUnkeptPath());
  EXPECT_TRUE(document.isModified());
  ASSERT_TRUE(document.place(wall, Pose::translation({0.1, 0.2, 0.3})).ok());
  document.undo();
  document.redo();
  EXPECT_TRUE(document.paths().paths().empty()) << "edits of bodies leave kept paths alone";
}

TEST_F(WorkbenchDocumentTest, AnAssemblyPlanIsUnsavedUntilItIsSaved) {
  EXPECT_EQ(document.plan(), nullptr);
  const auto plan = std::make_shared<const AssemblyPlan>(test::somePlan());
  document.setPlan(plan);
  EXPECT_TRUE(document.isModified());
  const Scenario saved = document.contentFor("a.json");
  EXPECT_EQ(saved.plan, plan);
  document.noteSaved("a.json", saved);
  EXPECT_FALSE(document.isModified());
  ASSERT_TRUE(document.place(wall, Pose::translation({0.1, 0.2, 0.3})).ok());
  document.undo();
  EXPECT_EQ(document.plan(), plan) << "edits of bodies leave it alone";
  EXPECT_TRUE(document.isProblemSaved()) << "a plan is no part of the problem";
}

TEST_F(WorkbenchDocumentTest, WhileTheScenarioIsATemporaryOneTheOneOfBeforeIsSaved) {
  ASSERT_TRUE(document.place(wall, Pose::translation({0.1, 0.2, 0.3})).ok());
  const std::string mine = writeScenario(document.contentFor({}));
  const auto withoutWall = [](Scenario& scenario) { return removeBody("O1", scenario); };
  ASSERT_TRUE(document.editTemporarily(QStringLiteral("by hand"), withoutWall).ok());
  EXPECT_TRUE(document.isTemporary());
  EXPECT_TRUE(document.isModified());
  ASSERT_TRUE(document.place({AssemblyItem::Kind::Body, "O2"}, Pose::translation({1, 1, 1})).ok());
  EXPECT_NE(text(), mine);
  EXPECT_EQ(writeScenario(document.contentFor({})), mine);

  document.noteSaved(document.scenario()->file, document.contentFor(document.scenario()->file));
  EXPECT_FALSE(document.isModified());
  document.endTemporary();
  EXPECT_FALSE(document.isTemporary());
  EXPECT_FALSE(document.isModified()) << "the file has it";
  EXPECT_EQ(wallAt(), Vector3(0.1, 0.2, 0.3));
  EXPECT_EQ(writeScenario(document.contentFor({})), mine);
  EXPECT_FALSE(document.undoStack().canRedo()) << "the temporary scenario is gone";
  document.undo();
  EXPECT_TRUE(document.isModified());
}

TEST_F(WorkbenchDocumentTest, AnEditOfAJointMovesNoBodyAndIsOneStepBackAndForth) {
  const std::string before = text();
  const CollisionWorldPtr world = document.scenario()->problem.world;
  Changes announced;
  QObject::connect(&document, &WorkbenchDocument::changed, [&](Changes what) { announced |= what; });
  document.setJoints(QStringLiteral("Dissolve"), {{{JointKind::Screw, "O1", {"O2"}}, JointEdit::Word::Dissolved}});
  EXPECT_TRUE(announced & Change::Joints);
  EXPECT_FALSE(announced & Change::Arrangement);
  EXPECT_EQ(document.scenario()->problem.world, world);
  EXPECT_TRUE(document.isModified());
  EXPECT_TRUE(document.isProblemSaved()) << "no run depends on joints";
  const std::string after = text();
  EXPECT_NE(after, before);
  document.undo();
  EXPECT_EQ(text(), before);
  EXPECT_FALSE(document.isModified());
  document.redo();
  EXPECT_EQ(text(), after);
}

/// A temporary scenario has fewer bodies, and no edits of the joints of the others.
TEST_F(WorkbenchDocumentTest, AnEditOfAJointOfATemporaryScenarioIsNotDoneAgain) {
  const JointEdit lasting{{JointKind::Screw, "O1", {"O2"}}, JointEdit::Word::Dissolved};
  document.setJoints(QStringLiteral("Dissolve"), {lasting});
  ASSERT_TRUE(
      document.editTemporarily(QStringLiteral("By hand"), [](Scenario& scenario) { return removeBody("O1", scenario); })
          .ok());
  EXPECT_TRUE(document.current().joints.empty());
  document.setJoints(QStringLiteral("Make"), {{{JointKind::Unit, "O2", {"O3"}}, JointEdit::Word::Opened}});
  document.endTemporary();
  EXPECT_EQ(document.current().joints, std::vector<JointEdit>{lasting});
  EXPECT_FALSE(document.undoStack().canRedo());
}

TEST_F(WorkbenchDocumentTest, ATemporaryScenarioThatIsUndoneLeavesTheFileAsItWas) {
  const std::string before = text();
  const auto withoutWall = [](Scenario& scenario) { return removeBody("O1", scenario); };
  ASSERT_TRUE(document.editTemporarily(QStringLiteral("by hand"), withoutWall).ok());
  EXPECT_FALSE(document.isModified()) << "nobody has edited what the file has";
  document.undo();
  EXPECT_FALSE(document.isTemporary());
  EXPECT_FALSE(document.isModified());
  EXPECT_EQ(text(), before);
}

/// If only an end of the motion is moved, the object is not prepared again.
TEST_F(WorkbenchDocumentTest, WhatAnEditLeavesAloneIsNotPreparedAgain) {
  const ScenarioPtr before = document.scenario();
  const Pose start = Pose::translation(before->problem.start.position + Vector3(0.001, 0, 0));
  ASSERT_TRUE(document.place({AssemblyItem::Kind::Start, {}}, start).ok());
  EXPECT_EQ(&document.scenario()->problem.world->object(), &before->problem.world->object());
  EXPECT_EQ(document.scenario()->object.mesh, before->object.mesh);
}

}  // namespace
}  // namespace glissade
