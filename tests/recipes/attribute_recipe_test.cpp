// Carries out the recipe "Add a semantic attribute".
#include <gtest/gtest.h>

#include "engine/files/scenario_io.h"
#include "engine/places/semantic_model.h"
#include "engine/planning/coarse/strategy_rules.h"
#include "engine/planning/planner.h"
#include "tests/engine/files/scenario_fixture.h"
#include "tests/engine/places/attribute_conformance.h"
#include "tests/engine/support/environment_worlds.h"

namespace glissade {
namespace {

AttributeDefinition dustiness() {
  AttributeDefinition definition;
  definition.name = "dustiness";
  definition.label = Message(GLISSADE_TEXT("Dustiness"));
  definition.type = AttributeType::Number;
  definition.owner = AttributeOwner::Place;
  definition.description = Message(GLISSADE_TEXT("Dust in the place."));
  definition.minimum = 0.0;
  definition.maximum = 1.0;
  definition.initial = 0.25;
  return definition;
}

Result<ParsedRules> rulesWith(const AttributeTable& table) {
  const StrategyRules rules{"1", "distance * (1 + place.dustiness)", {{"1", false, "linear"}}};
  return parseRules(rules, table, idsOf(makeLocalPlannerRegistry()));
}

TEST(AttributeRecipe, ABuiltInOneIsADefinitionOfTheTable) {
  AttributeDefinition definition = dustiness();
  definition.builtIn = true;
  AttributeTable table;
  EXPECT_FALSE(rulesWith(table).ok());
  ASSERT_TRUE(table.add(definition).ok());
  expectSoundBuiltIn(*table.find(AttributeOwner::Place, "dustiness"));
  EXPECT_TRUE(rulesWith(table).ok());
}

TEST(AttributeRecipe, AUsersOneNeedsNoCode) {
  Scenario scenario = test::boxScenario();
  scenario.attributeDefinitions = {dustiness()};
  scenario.places = {{test::kHole, "Door", {{"dustiness", 0.75}}}};
  const Result<Scenario> read = parseScenario(writeScenario(scenario), "dusty.json");
  ASSERT_TRUE(read.ok()) << toString(read.error());
  const SemanticEdits edits = semanticEditsOf(*read);
  EXPECT_TRUE(rulesWith(*attributeTableOf(edits)).ok());

  const auto environment =
      test::environmentOf(test::wallWithAHole(), test::twoRooms(), {1.0 / 32, 16, 6, "region-growing"});
  const SemanticModel model(environment, test::wallWithAHole(), "object", edits);
  const auto at = [&](const Vector3& p_W) {
    return model.ofPlace(static_cast<std::size_t>(environment->map.placeAt(p_W)), "dustiness");
  };
  EXPECT_EQ(at(test::kHole).value, AttributeValue(0.75));
  EXPECT_EQ(at(test::kLeft).value, AttributeValue(0.25));
  EXPECT_EQ(at(test::kLeft).provenance, Provenance::Initial);
}

TEST(AttributeRecipe, AFileWithAValueOutOfBoundsIsRefused) {
  Scenario scenario = test::boxScenario();
  scenario.attributeDefinitions = {dustiness()};
  scenario.places = {{test::kHole, "Door", {{"dustiness", 1.5}}}};
  const Result<Scenario> read = parseScenario(writeScenario(scenario), "dusty.json");
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(toString(read.error().location), "/places/0/attributes/dustiness");
}

}  // namespace
}  // namespace glissade
