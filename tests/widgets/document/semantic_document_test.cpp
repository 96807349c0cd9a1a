#include <gtest/gtest.h>

#include <QSignalSpy>

#include "engine/files/scenario_io.h"
#include "tests/engine/support/directories.h"
#include "widgets/document/semantic_document.h"

namespace glissade {
namespace {

class SemanticDocumentTest : public testing::Test {
 protected:
  SemanticDocumentTest() {
    auto loaded = loadScenario(test::sourceDirectory() + "/samples/teaching/scenario.json");
    scenario = std::make_shared<const LoadedScenario>(std::move(*loaded));
    document.open(*scenario);
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
  QUndoStack undo;
  SemanticDocument document{undo};
};

TEST_F(SemanticDocumentTest, AnEditOfSeveralPlacesIsOneStepBack) {
  const SemanticEdits before = document.edits();
  ASSERT_TRUE(document.setAttribute(places({0, 1}), "complexity", AttributeValue(7.0)).ok());
  EXPECT_EQ(complexity(0), 7.0);
  EXPECT_EQ(complexity(1), 7.0);
  EXPECT_EQ(undo.count(), 1);
  undo.undo();
  EXPECT_TRUE(document.edits() == before);
  undo.redo();
  EXPECT_EQ(complexity(1), 7.0);
}

TEST_F(SemanticDocumentTest, APlaceThatAnotherModelLacksIsNoLongerSelected) {
  const auto count = [](const SceneKnowledge& known) { return static_cast<int>(known.environment->map.places.size()); };
  const int before = count(*document.knowledge());
  auto other = loadScenario(test::sourceDirectory() + "/samples/sliding-plane/scenario.json");
  const SceneKnowledgePtr fewer = *buildSceneKnowledge(other->problem, 1e-6);
  ASSERT_LT(count(*fewer), before);
  document.select(places({0, before - 1}));
  QSignalSpy selected(&document, &SemanticDocument::selectionChanged);
  QObject::connect(&document, &SemanticDocument::changed, [&] { EXPECT_EQ(document.selection(), places({0})); });
  document.setKnowledge(fewer);
  EXPECT_EQ(selected.count(), 1);
}

/// The attributes of an assembly hold for its bodies, unless a body has its own value.
TEST_F(SemanticDocumentTest, AnAssemblysAttributesAreThoseOfItsBodies) {
  LoadedScenario loaded = *scenario;
  ASSERT_GE(loaded.obstacles.size(), 2U);
  const QString one = QString::fromStdString(loaded.obstacles[0].id.text());
  const QString two = QString::fromStdString(loaded.obstacles[1].id.text());
  loaded.product = Product({{loaded.obstacles[0].id, {"unit/a"}}, {loaded.obstacles[1].id, {"unit/b"}}});
  document.open(loaded);
  SemanticSelection unit;
  unit.bodies.insert(QStringLiteral("unit"));
  document.select(unit);
  EXPECT_EQ(document.selectedBodies(), (QSet<QString>{one, two}));
  ASSERT_TRUE(document.setAttribute(unit, "fragile", AttributeValue(true)).ok());
  EXPECT_EQ(document.bodyValue(one, "fragile").value, AttributeValue(true));
  EXPECT_EQ(document.bodyValue(one, "fragile").provenance, Provenance::Inherited);
  EXPECT_EQ(document.bodyValue(QStringLiteral("unit"), "fragile").provenance, Provenance::Edited);
  SemanticSelection body;
  body.bodies.insert(two);
  ASSERT_TRUE(document.setAttribute(body, "fragile", AttributeValue(false)).ok());
  EXPECT_EQ(document.bodyValue(two, "fragile").value, AttributeValue(false));
  EXPECT_EQ(document.heldEdits().bodies.at(one.toStdString()), (Attributes{{"fragile", true}}));
  EXPECT_EQ(document.heldEdits().bodies.count("unit"), 0U);
  undo.undo();
  EXPECT_EQ(document.bodyValue(two, "fragile").provenance, Provenance::Inherited);
}

TEST_F(SemanticDocumentTest, ADragOfOneEditorIsOneStepAndBackToTheStartIsNone) {
  for (const double value : {5.0, 6.0, 7.0}) {
    ASSERT_TRUE(document.setAttribute(places({2}), "complexity", AttributeValue(value)).ok());
  }
  EXPECT_EQ(undo.count(), 1);
  ASSERT_TRUE(document.setAttribute(places({3}), "complexity", AttributeValue(5.0)).ok());
  EXPECT_EQ(undo.count(), 2);
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
  EXPECT_EQ(undo.count(), 0);
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
  undo.undo();
  EXPECT_EQ(document.semantics()->ofPlace(0, "very_hot").value, AttributeValue(true));
}

TEST_F(SemanticDocumentTest, AnEditStaysWhereABodyComesToStandAndIsAsked) {
  const int place = document.knowledge()->environment->map.placeAt({1.49, 1.49, 0.3});
  ASSERT_TRUE(document.setAttribute(places({place}), "forbidden", AttributeValue(true)).ok());
  SemanticSelection body;
  body.bodies.insert(QStringLiteral("O5"));  // the body stands on the widest spot of the place
  ASSERT_TRUE(document.setAttribute(body, "mobility", AttributeValue(std::string("static"))).ok());
  EXPECT_TRUE(document.warnings().empty());
  Problem problem = scenario->problem;
  problem.scene.edits = std::make_shared<const SemanticEdits>(document.edits());
  document.setKnowledge(*buildSceneKnowledge(problem, 1e-6));
  const auto isForbidden = [&](int number) {
    return document.semantics()->ofPlace(static_cast<std::size_t>(number), "forbidden").value == AttributeValue(true);
  };
  std::vector<int> forbidden;
  for (int i = 0; i < static_cast<int>(document.semantics()->placeCount()); ++i) {
    if (isForbidden(i)) forbidden.push_back(i);
  }
  ASSERT_EQ(forbidden.size(), 1U);
  ASSERT_EQ(document.warnings().size(), 1U);
  EXPECT_EQ(toString(document.warnings().front().location), "/places/0");
  // A second edit binds the attributes to the place for which they count now.
  ASSERT_TRUE(document.setAttribute(places({forbidden[0]}), "preference", AttributeValue(2.0)).ok());
  EXPECT_EQ(document.edits().places.size(), 1U);
  EXPECT_TRUE(document.warnings().empty());
}

TEST_F(SemanticDocumentTest, EditsThatCountNowhereAreRemovedAndComeBack) {
  EXPECT_FALSE(document.hasStrays());
  auto other = std::make_shared<LoadedScenario>(*scenario);
  other->scenario.places.push_back({{50.0, 50.0, 50.0}, "Hall", {}});
  document.rearrange(*other);
  ASSERT_TRUE(document.hasStrays());
  ASSERT_FALSE(document.warnings().empty());
  document.removeStrays();
  EXPECT_FALSE(document.hasStrays());
  EXPECT_TRUE(document.warnings().empty());
  undo.undo();
  EXPECT_TRUE(document.hasStrays());
}

TEST_F(SemanticDocumentTest, TwoEditsOfAPlaceAreTakenBackTogether) {
  Scenario twice = scenario->scenario;
  const Vector3 at = document.knowledge()->environment->map.places[0].anchor;
  twice.places = {{at, "", {{"forbidden", true}}}, {at, "", {{"complexity", 5.0}}}};
  auto other = std::make_shared<LoadedScenario>(*scenario);
  other->scenario = twice;
  document.rearrange(*other);
  EXPECT_EQ(document.warnings().size(), 1U);
  ASSERT_TRUE(document.setAttribute(places({0}), "forbidden", std::nullopt).ok());
  EXPECT_EQ(document.semantics()->ofPlace(0, "forbidden").value, AttributeValue(false));
  EXPECT_EQ(complexity(0), 5.0);
}

TEST_F(SemanticDocumentTest, AnotherGestureIsAnotherStepBack) {
  for (const double value : {7.0, 3.0, 9.0}) {
    ASSERT_TRUE(document.setAttribute(places({2}), "complexity", AttributeValue(value)).ok());
    document.endGesture();
  }
  EXPECT_EQ(undo.count(), 3);
  undo.undo();
  EXPECT_EQ(complexity(2), 3.0);
  // An edit after an undo is not merged with the edit before.
  ASSERT_TRUE(document.setAttribute(places({2}), "complexity", AttributeValue(8.0)).ok());
  undo.undo();
  EXPECT_EQ(complexity(2), 3.0);
}

TEST_F(SemanticDocumentTest, AnAttributeThatARuleUsesStaysAsItIs) {
  AttributeDefinition hazard;
  hazard.name = "hazard";
  hazard.type = AttributeType::Number;
  hazard.initial = 0.0;
  auto other = std::make_shared<LoadedScenario>(*scenario);
  other->scenario.attributeDefinitions = {hazard};
  other->scenario.rules = presetRules("gts");
  other->scenario.rules->edge = "distance * (1 + place.hazard)";
  document.rearrange(*other);
  const SemanticEdits before = document.edits();
  for (const Outcome& refused : {document.renameDefinition(AttributeOwner::Place, "hazard", "danger"),
                                 document.removeDefinition(AttributeOwner::Place, "hazard")}) {
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(toString(refused.error().reason).find("/rules/edge"), std::string::npos)
        << toString(refused.error().reason);
    EXPECT_NE(toString(refused.error().reason).find("'hazard'"), std::string::npos) << toString(refused.error().reason);
  }
  EXPECT_TRUE(document.edits() == before);
}

TEST_F(SemanticDocumentTest, ASelectionIsAnnouncedOnceAChange) {
  QSignalSpy changes(&document, &SemanticDocument::selectionChanged);
  document.select(places({1}));
  document.select(places({1}));
  EXPECT_EQ(changes.count(), 1);
}

TEST_F(SemanticDocumentTest, PlacesHaveNamesOfTheirOwn) {
  ASSERT_TRUE(document.renamePlace(0, QStringLiteral("hall")).ok());
  EXPECT_FALSE(document.renamePlace(1, QStringLiteral("hall")).ok());
  EXPECT_EQ(document.semantics()->placeName(0), "hall");
}

}  // namespace
}  // namespace glissade
