#include "engine/sequence/step_cost.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

SequenceDemands withCost(const std::string& text) {
  SequenceDemands demands;
  demands.cost = text;
  demands.attributes["wheel"] = {{"price", 20.0}, {"colour", std::string("red")}, {"new", true}};
  return demands;
}

double costOf(const std::string& text, const StepFigures& figures) {
  const auto cost = StepCost::of(withCost(text));
  EXPECT_TRUE(cost.ok()) << text;
  return cost ? cost->of(figures) : -1.0;
}

TEST(StepCost, KnowsTheFiguresOfAStep) {
  const StepFigures figures{1.5, 2.0, true, false, 3.0, 4.0, 5.0, true, "wheel"};
  EXPECT_EQ(costOf("length", figures), 1.5);
  EXPECT_EQ(costOf("turns", figures), 2.0);
  EXPECT_EQ(costOf("direction_change + 2 * tool_change", figures), 1.0);
  EXPECT_EQ(costOf("falling", figures), 3.0);
  EXPECT_EQ(costOf("bodies", figures), 4.0);
  EXPECT_EQ(costOf("mass", figures), 5.0);
  EXPECT_EQ(costOf("if(fragile, 7, 8)", figures), 7.0);
  EXPECT_EQ(costOf("balanced", figures), 1.5 + 1.0 + 30.0);
  EXPECT_EQ(costOf("", figures), 30.0 + 1.0) << "the usual one";
  StepFigures around;
  around.toolBlocked = around.taskChange = true;
  around.assemblyChange = 0.5;
  around.distance = 0.25;
  around.size = 0.125;
  around.early = 0.75;
  EXPECT_EQ(costOf("tool_blocked + 2 * task_change", around), 3.0);
  EXPECT_EQ(costOf("assembly_change + distance", around), 0.75);
  EXPECT_EQ(costOf("size + early", around), 0.875);
  around.inAir = true;
  around.unfastened = 2.0;
  around.openStacks = 3.0;
  EXPECT_EQ(costOf("100 * in_air + 10 * unfastened + open_stacks", around), 123.0);
  EXPECT_EQ(costOf("as-found", around), 0.0);
}

TEST(StepCost, KnowsTheAttributesOfTheBody) {
  StepFigures figures;
  figures.id = "wheel";
  EXPECT_EQ(costOf("body.price + body.new", figures), 21.0);
  EXPECT_EQ(costOf("if(body.colour == \"red\", 2, 1)", figures), 2.0);
  figures.id = "frame";
  EXPECT_EQ(costOf("body.price", figures), 0.0);
  EXPECT_EQ(costOf("if(body.colour == \"red\", 2, 1)", figures), 1.0);
}

TEST(StepCost, IsNeverBelowZeroNorNoNumber) {
  EXPECT_EQ(costOf("-3", {}), 0.0);
  EXPECT_EQ(costOf("0 / 0", {}), 0.0);
}

TEST(StepCost, RefusesUnknownNamesAndWhatDoesNotParse) {
  for (const char* text : {"lenght", "body.weight", "length +", "\"far\""}) {
    const auto cost = StepCost::of(withCost(text));
    ASSERT_FALSE(cost.ok()) << text;
    EXPECT_EQ(toString(cost.error().location), "/sequence/cost");
  }
}

TEST(StepCost, PresetsParse) {
  for (const StepCostPreset& preset : stepCostPresets()) {
    const auto cost = StepCost::of(withCost(preset.id));
    ASSERT_TRUE(cost.ok()) << preset.id;
    EXPECT_EQ(cost->text(), preset.expression);
  }
}

}  // namespace
}  // namespace glissade
