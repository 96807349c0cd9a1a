#include "engine/base/describe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/base/json_formats.h"

namespace glissade::describe_test {

struct Hole {
  double radius = 0.001;
  std::string name{};
  std::optional<double> depth{};
  std::vector<Hole> inner{};
};

struct Drawing {
  Hole hole{};
  int sheet = 1;
};

struct Impostor {};

template <class Archive>
void describe(Archive& hole, Type<Hole> /*type*/) {
  hole.type("hole", "A cylinder that is cut out.");
  hole.required("radius", &Hole::radius, kLength, "Metres.");
  hole.optional("name", &Hole::name, kText);
  hole.optional("depth", &Hole::depth, kLength);
  hole.optional("inner", &Hole::inner, kObjects<Hole>);
  hole.ignored("remark", kText);
  hole.computed(
      "diameter", [](const Hole& of) { return 2.0 * of.radius; }, kNumber);
  hole.check([](const Hole& read, const JsonCursor& at) {
    if (read.radius > 1.0) at.at("radius").fail(Message("is too large"));
  });
}

template <class Archive>
void describe(Archive& drawing, Type<Drawing> /*type*/) {
  drawing.type("drawing");
  drawing.constant("format", "drawing");
  drawing.constant("version", 1);
  drawing.embed(&Drawing::hole);
  drawing.optional("sheet",
                   Accessor{[](const Drawing& of) { return static_cast<std::uint64_t>(of.sheet); },
                            [](Drawing& of, std::uint64_t sheet) { of.sheet = static_cast<int>(sheet); }},
                   kCount, "", Always());
}

template <class Archive>
void describe(Archive& impostor, Type<Impostor> /*type*/) {
  impostor.type("hole");
}

namespace {

using Json = JsonCursor::Json;

Result<Drawing> readDrawing(const std::string& text) { return readJson(text, "d.json", readDescribed<Drawing>); }

TEST(Describe, WhatIsWrittenIsReadAndWrittenAgain) {
  Drawing drawing{{0.25, "bore", 0.5, {{0.125}}}, 3};
  const Json json = writeDescribed(drawing);
  EXPECT_EQ(json.dump(), R"({"format":"drawing","version":1,"radius":0.25,"name":"bore","depth":0.5,)"
                         R"("inner":[{"radius":0.125,"diameter":0.25}],"diameter":0.5,"sheet":3})");
  const auto read = readDrawing(json.dump());
  ASSERT_TRUE(read) << toString(read.error());
  EXPECT_EQ(writeDescribed(*read), json);
  EXPECT_EQ(read->hole.inner.size(), 1U);
}

TEST(Describe, AbsentMembersKeepTheirInitialValues) {
  const auto read = readDrawing(R"({"format": "drawing", "version": 1, "radius": 0.25, "remark": "old"})");
  ASSERT_TRUE(read) << toString(read.error());
  EXPECT_EQ(read->sheet, 1);
  EXPECT_FALSE(read->hole.depth);
  EXPECT_EQ(writeDescribed(*read).dump(), R"({"format":"drawing","version":1,"radius":0.25,"diameter":0.5,"sheet":1})");
}

TEST(Describe, EachFaultIsNamedWithItsPlace) {
  const std::pair<const char*, const char*> faults[] = {
      {R"({"format": "plan", "version": 1, "radius": 0.25})", "/format"},
      {R"({"format": "drawing", "version": 2, "radius": 0.25})", "/version"},
      {R"({"format": "drawing", "version": 1})", "/radius"},
      {R"({"format": "drawing", "version": 1, "radius": 0.25, "colour": 1})", "/colour"},
      {R"({"format": "drawing", "version": 1, "radius": 2})", "/radius"},
      {R"({"format": "drawing", "version": 1, "radius": 0.25, "remark": 1})", "/remark"},
      {R"({"format": "drawing", "version": 1, "radius": 0.25, "inner": [{"radius": 0.25, "x": 1}]})", "/inner/0/x"}};
  for (const auto& [text, place] : faults) {
    const auto read = readDrawing(text);
    ASSERT_FALSE(read) << text;
    EXPECT_EQ(toString(read.error().location), place) << text;
  }
}

TEST(Describe, AnUnknownKeyIsToldWithAllKeys) {
  const auto read = readDrawing(R"({"strange": 1})");
  ASSERT_FALSE(read);
  EXPECT_THAT(toString(read.error().advice),
              testing::HasSubstr("format, version, radius, name, depth, inner, remark, diameter, sheet"));
}

TEST(Describe, TheSchemaOfATypeThatContainsItselfIsFinite) {
  const Json schema = describedSchema<Drawing>("Drawing");
  EXPECT_EQ(schema["required"], Json({"format", "version", "radius"}));
  EXPECT_EQ(schema["properties"]["format"], Json({{"const", "drawing"}}));
  EXPECT_EQ(schema["properties"]["inner"]["items"], Json({{"$ref", "#/definitions/hole"}}));
  const Json& hole = schema["definitions"]["hole"];
  EXPECT_EQ(hole["description"], "A cylinder that is cut out.");
  EXPECT_EQ(hole["properties"]["inner"]["items"], Json({{"$ref", "#/definitions/hole"}}));
  EXPECT_EQ(hole["additionalProperties"], false);
}

TEST(Describe, TwoTypesOfOneNameAreRefused) {
  SchemaDefinitions definitions;
  definitions.reference<Hole>();
  EXPECT_THROW(definitions.reference<Impostor>(), std::logic_error);
}

}  // namespace
}  // namespace glissade::describe_test
