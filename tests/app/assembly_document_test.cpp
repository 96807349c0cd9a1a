#include "widgets/model/assembly_document.h"

#include <gtest/gtest.h>

#include "engine/scenario/scenario_io.h"

namespace glissade {
namespace {

class AssemblyDocumentTest : public testing::Test {
 protected:
  AssemblyDocumentTest() : document(semantics) {
    auto loaded = loadScenario(GLISSADE_SOURCE_DIR "/samples/teaching/scenario.json");
    const auto scenario = std::make_shared<const LoadedScenario>(std::move(*loaded));
    semantics.open(scenario);
    document.open(scenario);
  }

  std::string text() const { return writeScenario(document.current()); }

  const AssemblyItem wall{AssemblyItem::Kind::Body, "O1"};
  SemanticDocument semantics;
  AssemblyDocument document;
};

TEST_F(AssemblyDocumentTest, AMoveIsOneStepBackAndForth) {
  const std::string before = text();
  int rearranged = 0;
  QObject::connect(&document, &AssemblyDocument::rearranged, [&] { ++rearranged; });
  ASSERT_TRUE(document.place(wall, Pose::translation({0.1, 0.2, 0.3})).ok());
  const std::string after = text();
  EXPECT_NE(after, before);
  EXPECT_EQ(document.scenario()->obstacles.front().X_WB.position, Vector3(0.1, 0.2, 0.3));
  semantics.undoStack().undo();
  EXPECT_EQ(text(), before);
  semantics.undoStack().redo();
  EXPECT_EQ(text(), after);
  EXPECT_EQ(rearranged, 3);
  ASSERT_TRUE(document.place(wall, Pose::translation({0.1, 0.2, 0.3})).ok());
  EXPECT_EQ(rearranged, 3) << "nothing was moved";
}

TEST_F(AssemblyDocumentTest, StepsOfOneNumberAreOneStepBack) {
  const std::string before = text();
  for (const double x : {0.1, 0.2, 0.3}) {
    ASSERT_TRUE(document.place(wall, Pose::translation({x, 0, 0}), QStringLiteral("x")).ok());
  }
  EXPECT_EQ(semantics.undoStack().count(), 1);
  semantics.undoStack().undo();
  EXPECT_EQ(text(), before);
}

TEST_F(AssemblyDocumentTest, ABodyComesBackWithItsAttributesInAnyOrderOfEdits) {
  SemanticSelection selected;
  selected.bodies.insert(QStringLiteral("O1"));
  ASSERT_TRUE(semantics.setAttribute(selected, "shape", AttributeValue(std::string("wall"))).ok());
  ASSERT_TRUE(document.place(wall, Pose::translation({0, 0, 1})).ok());
  semantics.select(selected);
  Scenario without = document.current();
  ASSERT_TRUE(removeBody("O1", without).ok());
  ASSERT_TRUE(document.edit(QStringLiteral("Remove"), without).ok());
  EXPECT_EQ(semantics.edits().bodies.count("O1"), 0U);
  EXPECT_TRUE(semantics.selection().bodies.isEmpty());
  semantics.undoStack().undo();
  EXPECT_EQ(semantics.bodyValue(QStringLiteral("O1"), "shape").value, AttributeValue(std::string("wall")));
  EXPECT_EQ(document.scenario()->obstacles.front().X_WB.position, Vector3(0, 0, 1));
  semantics.undoStack().undo();
  semantics.undoStack().undo();
  EXPECT_FALSE(semantics.undoStack().canUndo());
  EXPECT_EQ(semantics.edits().bodies.count("O1"), 0U);
}

TEST_F(AssemblyDocumentTest, IsSavedWhileTheFileSaysTheSame) {
  EXPECT_TRUE(document.isSaved());
  ASSERT_TRUE(document.place(wall, Pose::translation({0, 0, 1})).ok());
  EXPECT_FALSE(document.isSaved());
  semantics.undoStack().undo();
  EXPECT_TRUE(document.isSaved());
}

TEST_F(AssemblyDocumentTest, WhatCannotBeLoadedIsRefusedAndChangesNothing) {
  const std::string before = text();
  Scenario broken = document.current();
  broken.assets.push_back({"gone", "gone.stl", "", 1.0, UpAxis::Z});
  broken.object.geometry = MeshGeometry{"gone"};
  const Outcome outcome = document.edit(QStringLiteral("Break"), broken);
  ASSERT_FALSE(outcome.ok());
  EXPECT_NE(outcome.error().file.find("gone.stl"), std::string::npos);
  EXPECT_EQ(text(), before);
  EXPECT_FALSE(semantics.undoStack().canUndo());
}

}  // namespace
}  // namespace glissade
