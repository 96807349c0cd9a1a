#include <gtest/gtest.h>

#include <QSignalSpy>

#include "engine/scenario/scenario_io.h"
#include "widgets/model/semantic_document.h"

namespace glissade {
namespace {

class SemanticDocumentTest : public testing::Test {
 protected:
  SemanticDocumentTest() {
    auto loaded = loadScenario(GLISSADE_SOURCE_DIR "/samples/teaching/scenario.json");
    scenario = std::make_shared<const LoadedScenario>(std::move(*loaded));
    document.open(scenario);
    document.setKnowledge(*buildSceneKnowledge(scenario->problem, 1e-6));
  }

  static SemanticSelection places(std::initializer_list<int> numbers) {
    SemanticSelection selection;
    for (const int number : numbers) selection.places.insert(number);
    return selection;
  }
  double complexity(std::size_t place) const {
    return std::get<double>(document.semantics()->ofPlace(place, "complexity").value);
  }

  std::shared_ptr<const LoadedScenario> scenario;
  SemanticDocument document;
};

TEST_F(SemanticDocumentTest, AnEditOfSeveralPlacesIsOneStepBack) {
  const SemanticEdits before = document.edits();
  ASSERT_TRUE(document.setAttribute(places({0, 1}), "complexity", AttributeValue(7.0)).ok());
  EXPECT_EQ(complexity(0), 7.0);
  EXPECT_EQ(complexity(1), 7.0);
  EXPECT_EQ(document.undoStack().count(), 1);
  document.undoStack().undo();
  EXPECT_TRUE(document.edits() == before);
  document.undoStack().redo();
  EXPECT_EQ(complexity(1), 7.0);
}

TEST_F(SemanticDocumentTest, ADragOfOneEditorIsOneStepAndBackToTheStartIsNone) {
  for (const double value : {5.0, 6.0, 7.0}) {
    ASSERT_TRUE(document.setAttribute(places({2}), "complexity", AttributeValue(value)).ok());
  }
  EXPECT_EQ(document.undoStack().count(), 1);
  ASSERT_TRUE(document.setAttribute(places({3}), "complexity", AttributeValue(5.0)).ok());
  EXPECT_EQ(document.undoStack().count(), 2);
}

TEST_F(SemanticDocumentTest, ResetGivesTheComputedValueBackAndLeavesNothingBehind) {
  const SemanticEdits before = document.edits();
  ASSERT_TRUE(document.setAttribute(places({0}), "complexity", AttributeValue(9.0)).ok());
  ASSERT_TRUE(document.setAttribute(places({0}), "complexity", std::nullopt).ok());
  EXPECT_TRUE(document.edits() == before);
  EXPECT_EQ(document.semantics()->ofPlace(0, "complexity").provenance, Provenance::Computed);
}

TEST_F(SemanticDocumentTest, WhatIsRefusedChangesNothing) {
  const SemanticEdits before = document.edits();
  EXPECT_FALSE(document.setAttribute(places({0}), "compatibility", AttributeValue(2.0)).ok());
  EXPECT_FALSE(document.setAttribute(places({0}), "complexity", AttributeValue(std::string("hard"))).ok());
  EXPECT_FALSE(document.setAttribute(places({0}), "no_such", AttributeValue(1.0)).ok());
  EXPECT_TRUE(document.edits() == before);
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(SemanticDocumentTest, AttributesOfOnesOwnAreAddedRenamedAndRemovedWithTheirValues) {
  AttributeDefinition definition;
  definition.name = "hot";
  definition.type = AttributeType::Bool;
  definition.initial = false;
  ASSERT_TRUE(document.addDefinition(definition).ok());
  EXPECT_FALSE(document.addDefinition(definition).ok());
  ASSERT_TRUE(document.setAttribute(places({0}), "hot", AttributeValue(true)).ok());
  ASSERT_TRUE(document.renameDefinition(AttributeOwner::Place, "hot", "very_hot").ok());
  EXPECT_EQ(document.semantics()->ofPlace(0, "very_hot").value, AttributeValue(true));
  EXPECT_FALSE(document.renameDefinition(AttributeOwner::Place, "very_hot", "complexity").ok());
  ASSERT_TRUE(document.removeDefinition(AttributeOwner::Place, "very_hot").ok());
  EXPECT_EQ(document.table().find(AttributeOwner::Place, "very_hot"), nullptr);
  document.undoStack().undo();
  EXPECT_EQ(document.semantics()->ofPlace(0, "very_hot").value, AttributeValue(true));
}

TEST_F(SemanticDocumentTest, SelectionIsToldOnceAChange) {
  QSignalSpy told(&document, &SemanticDocument::selectionChanged);
  document.select(places({1}));
  document.select(places({1}));
  EXPECT_EQ(told.count(), 1);
}

TEST_F(SemanticDocumentTest, PlacesHaveNamesOfTheirOwn) {
  ASSERT_TRUE(document.renamePlace(0, QStringLiteral("hall")).ok());
  EXPECT_FALSE(document.renamePlace(1, QStringLiteral("hall")).ok());
  EXPECT_EQ(document.semantics()->placeName(0), "hall");
}

}  // namespace
}  // namespace glissade
