#include "engine/places/attribute.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/engine/places/attribute_conformance.h"

namespace glissade {
namespace {

using testing::HasSubstr;

AttributeDefinition definitionOf(AttributeType type, double minimum = -1e9, double maximum = 1e9) {
  AttributeDefinition definition;
  definition.name = "thing";
  definition.type = type;
  definition.minimum = minimum;
  definition.maximum = maximum;
  if (type == AttributeType::Choice) definition.choices = {"red", "green"};
  definition.initial = initialValue(definition);
  return definition;
}

TEST(AttributeTable, HasTheBuiltInAttributesWithSoundFirstValues) {
  const AttributeTable table;
  for (const char* name :
       {"complexity", "cluttered", "narrowness", "shape", "compatibility", "forbidden", "preference"}) {
    EXPECT_NE(table.find(AttributeOwner::Place, name), nullptr) << name;
  }
  for (const char* name : {"mobility", "shape"}) EXPECT_NE(table.find(AttributeOwner::Body, name), nullptr) << name;
  EXPECT_EQ(table.find(AttributeOwner::Body, "forbidden"), nullptr);
  for (const AttributeDefinition& definition : table.definitions()) expectSoundBuiltIn(definition);
}

TEST(AttributeTable, AddsWhatIsSoundAndKeepsTheOrder) {
  AttributeTable table;
  const std::size_t builtIn = table.definitions().size();
  ASSERT_TRUE(table.add(definitionOf(AttributeType::Choice)));
  AttributeDefinition second = definitionOf(AttributeType::Bool);
  second.owner = AttributeOwner::Body;  // the same name for another owner
  ASSERT_TRUE(table.add(second));
  ASSERT_EQ(table.definitions().size(), builtIn + 2);
  EXPECT_EQ(table.definitions().back(), second);
  EXPECT_EQ(table.find(AttributeOwner::Place, "thing")->type, AttributeType::Choice);
}

TEST(AttributeTable, RefusesChoicesWithoutANameOrTwice) {
  AttributeTable table;
  AttributeDefinition definition = definitionOf(AttributeType::Choice);
  definition.choices = {"low", "high", ""};
  EXPECT_FALSE(table.add(definition).ok());
  definition.choices = {"red", "green", "red"};
  EXPECT_THAT(toString(table.add(definition).error().reason), HasSubstr("'red' twice"));
}

TEST(AttributeTable, RefusesWhatCouldNotBeUsed) {
  const auto refused = [](const char* reason, const AttributeDefinition& definition) {
    AttributeTable table;
    const std::size_t before = table.definitions().size();
    const Outcome added = table.add(definition);
    ASSERT_FALSE(added.ok()) << reason;
    EXPECT_EQ(added.error().kind, ErrorKind::MalformedInput);
    EXPECT_THAT(toString(added.error().reason), HasSubstr(reason));
    EXPECT_EQ(table.definitions().size(), before);
  };
  AttributeDefinition definition = definitionOf(AttributeType::Number);
  for (const char* name : {"", "Speed", "2nd", "max speed", "max-speed", "größe", "a.b"}) {
    definition.name = name;
    refused("not a word", definition);
  }
  definition.name = "complexity";
  refused("already", definition);
  definition = definitionOf(AttributeType::Choice);
  definition.choices.clear();
  refused("no choices", definition);
  refused("above its maximum", definitionOf(AttributeType::Number, 2, 1));
  definition = definitionOf(AttributeType::Integer, 1, 5);
  definition.initial = 2.5;
  refused("whole number", definition);
}

TEST(CheckValue, AcceptsTheRightTypeInRangeOnly) {
  using T = AttributeType;
  struct Row {
    AttributeDefinition definition;
    AttributeValue value;
    bool sound;
  };
  const AttributeValue nan = std::nan("");
  const AttributeValue infinite = std::numeric_limits<double>::infinity();
  const std::vector<Row> rows{
      {definitionOf(T::Bool), true, true},
      {definitionOf(T::Bool), 1.0, false},
      {definitionOf(T::Bool), std::string("true"), false},
      {definitionOf(T::Integer, 1, 3), 1.0, true},
      {definitionOf(T::Integer, 1, 3), 3.0, true},
      {definitionOf(T::Integer, 1, 3), 2.5, false},
      {definitionOf(T::Integer, 1, 3), 4.0, false},
      {definitionOf(T::Integer, 1, 3), true, false},
      {definitionOf(T::Number, 0, 1), 0.5, true},
      {definitionOf(T::Number, 0, 1), 2.0, false},
      {definitionOf(T::Number, 0, 1), -0.001, false},
      {definitionOf(T::Number), nan, false},
      {definitionOf(T::Number), infinite, false},
      {definitionOf(T::Number), std::string("1"), false},
      {definitionOf(T::Text), std::string(), true},
      {definitionOf(T::Text), 1.0, false},
      {definitionOf(T::Choice), std::string("green"), true},
      {definitionOf(T::Choice), std::string("blue"), false},
      {definitionOf(T::Choice), false, false},
  };
  for (const Row& row : rows) {
    const Outcome checked = checkValue(row.definition, row.value);
    EXPECT_EQ(checked.ok(), row.sound) << kAttributeTypeNames.of(row.definition.type) << " " << toText(row.value);
    if (!checked.ok()) {
      EXPECT_THAT(toString(checked.error().reason), HasSubstr("'thing'"));
      EXPECT_FALSE(checked.error().advice.empty());
    }
  }
}

TEST(AttributeType, NamesAreFoundAgainAndValuesAreReadable) {
  for (const AttributeType type : {AttributeType::Bool, AttributeType::Integer, AttributeType::Number,
                                   AttributeType::Text, AttributeType::Choice}) {
    EXPECT_EQ(kAttributeTypeNames.find(kAttributeTypeNames.of(type)), type);
    EXPECT_TRUE(checkValue(definitionOf(type, 2, 4), initialValue(definitionOf(type, 2, 4))).ok())
        << kAttributeTypeNames.of(type);
  }
  EXPECT_FALSE(kAttributeTypeNames.find("real"));
  EXPECT_EQ(toText(AttributeValue(true)), "yes");
  EXPECT_EQ(toText(AttributeValue(3.0)), "3");
  EXPECT_EQ(toText(AttributeValue(0.25)), "0.25");
  EXPECT_EQ(toText(AttributeValue(std::string("circle"))), "circle");
}

}  // namespace
}  // namespace glissade
