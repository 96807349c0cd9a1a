#include "engine/files/sequence_knowledge.h"

#include <gtest/gtest.h>

#include "engine/files/body_classes_json.h"
#include "engine/places/semantic_model.h"
#include "engine/sequence/step_cost.h"
#include "tests/engine/files/scenario_fixture.h"

namespace glissade {
namespace {

/// A scenario with bodies "rail" and "screws", whose STEP file has two parts.
struct KnownScenario {
  KnownScenario() {
    scenario.bodies.resize(2);
    scenario.bodies[0].id = "rail";
    scenario.bodies[1].id = "screws";
    for (const char* id : {"rail", "screws/one", "screws/two"}) {
      product.bodies.emplace_back();
      product.bodies.back().id = BodyId(id);
    }
  }
  SequenceDemands demands() const {
    const auto known = knownDemands(scenario, product);
    EXPECT_TRUE(known.ok());
    return known ? *known : SequenceDemands();
  }
  Scenario scenario;
  AssembledProduct product;
};

TEST(SequenceKnowledge, AttributesBecomeDemands) {
  KnownScenario known;
  known.scenario.bodies[0].attributes = {{"base", true},
                                         {"mass", 2.5},
                                         {"fragile", true},
                                         {"goes_before", std::string("one, two")},
                                         {"needs_tool", std::string("none")}};
  const SequenceDemands demands = known.demands();
  EXPECT_EQ(demands.stay, std::vector<std::string>{"rail"});
  EXPECT_EQ(demands.fragile, std::vector<std::string>{"rail"});
  ASSERT_EQ(demands.masses.size(), 1U);
  EXPECT_EQ(demands.masses[0].second, 2.5);
  ASSERT_EQ(demands.before.size(), 2U);
  EXPECT_EQ(demands.before[1], (std::pair<std::string, std::string>{"rail", "two"}));
  EXPECT_EQ(demands.tools[0].second, "none");
}

TEST(SequenceKnowledge, PartsOfABodyHaveItsAttributesAndThoseOfItsClass) {
  KnownScenario known;
  known.scenario.bodies[1].attributes = {{"class", std::string("socket_head_screw")}};
  const SequenceDemands demands = known.demands();
  ASSERT_EQ(demands.tools.size(), 2U);
  EXPECT_EQ(demands.tools[1], (std::pair<std::string, std::string>{"screws/two", "hex_key"}));
  ASSERT_EQ(demands.fasteners.size(), 2U);
  EXPECT_EQ(demands.fasteners[0].second, "screw");
}

TEST(SequenceKnowledge, GroupsThatHaveABodyInCommonAreOne) {
  KnownScenario known;
  known.scenario.bodies[0].attributes = {{"goes_with", std::string("screws/one")}};
  known.scenario.sequence.together = {{"screws/one", "screws/two"}};
  const SequenceDemands demands = known.demands();
  ASSERT_EQ(demands.together.size(), 1U);
  EXPECT_EQ(demands.together[0].size(), 3U);
}

TEST(SequenceKnowledge, PartsHaveAttributesOfTheirOwnThatTheScenarioKeeps) {
  KnownScenario known;
  known.scenario.bodies[1].attributes = {{"class", std::string("nut")}};
  SemanticEdits edits = semanticEditsOf(known.scenario);
  edits.bodies["screws/one"] = {{"stays", true}};
  edits.bodies["screws/two"] = {};
  setSemanticEdits(edits, known.scenario);
  EXPECT_EQ(semanticEditsOf(known.scenario).bodies.at("screws/one"), (Attributes{{"stays", true}}));
  EXPECT_EQ(known.demands().stay, std::vector<std::string>{"screws/one"});
  EXPECT_EQ(known.demands().fasteners.size(), 2U);
  edits.bodies.erase("screws/one");
  setSemanticEdits(edits, known.scenario);
  EXPECT_TRUE(known.scenario.sequence.attributes.empty());
  edits.bodies["screw/one"] = {{"stays", true}};
  EXPECT_FALSE(checkEdits(edits, {"rail", "screws"}));
}

TEST(SequenceKnowledge, ClassesOfTheScenarioAreAdded) {
  KnownScenario known;
  known.scenario.sequence.classes = {{"glass", "fixture"}};
  known.scenario.bodies[0].attributes = {{"class", std::string("glass")}};
  EXPECT_EQ(known.demands().stay, std::vector<std::string>{"rail"}) << "a fixture is a base part";
  known.scenario.sequence.classes = {{"glass", "fixtur"}};
  const auto wrong = knownDemands(known.scenario, known.product);
  ASSERT_FALSE(wrong.ok());
  EXPECT_EQ(toString(wrong.error().location), "/sequence/classes");
}

TEST(SequenceKnowledge, RefusesAnUnknownClassAndNamesThoseThereAre) {
  KnownScenario known;
  known.scenario.bodies[0].attributes = {{"class", std::string("scrw")}};
  const auto wrong = knownDemands(known.scenario, known.product);
  ASSERT_FALSE(wrong.ok());
  EXPECT_NE(toString(wrong.error().reason).find("'scrw'"), std::string::npos);
  EXPECT_NE(toString(wrong.error().advice).find("socket_head_screw"), std::string::npos);
}

TEST(SequenceKnowledge, CostsMayNameTheUsersAttributes) {
  KnownScenario known;
  AttributeDefinition price;
  price.name = "price";
  price.type = AttributeType::Number;
  price.owner = AttributeOwner::Body;
  price.initial = 3.0;
  known.scenario.attributeDefinitions = {price};
  known.scenario.bodies[0].attributes = {{"price", 8.0}};
  known.scenario.sequence.cost = "body.price";
  const auto cost = StepCost::of(known.demands());
  ASSERT_TRUE(cost.ok());
  StepFigures figures;
  figures.id = "rail";
  EXPECT_EQ(cost->of(figures), 8.0);
  figures.id = "screws/two";
  EXPECT_EQ(cost->of(figures), 3.0) << "where nobody has said anything";
}

TEST(BodyClassesFile, IsReadAndWhole) {
  const auto classes = BodyClasses::of(usualBodyClasses());
  ASSERT_TRUE(classes.ok());
  EXPECT_GE(classes->all().size(), 10U);
  const AttributeTable table;
  for (const BodyClass& each : classes->all()) {
    for (const auto& [name, value] : each.attributes) {
      const AttributeDefinition* definition = table.find(AttributeOwner::Body, name);
      ASSERT_NE(definition, nullptr) << name;
      EXPECT_TRUE(checkValue(*definition, value)) << each.name;
    }
  }
}

}  // namespace
}  // namespace glissade
