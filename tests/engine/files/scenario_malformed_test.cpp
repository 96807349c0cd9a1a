#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/base/json_reader.h"
#include "engine/files/scenario_io.h"
#include "tests/engine/files/broken_scenarios.h"

namespace glissade {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

void expectRefused(const std::string& text, const std::string& place, const std::string& reason) {
  const Result<Scenario> read = parseScenario(text, "broken.json");
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().kind, ErrorKind::MalformedInput);
  EXPECT_EQ(read.error().file, "broken.json");
  EXPECT_THAT(toString(read.error().location), StartsWith(place));
  EXPECT_THAT(toString(read.error().reason), HasSubstr(reason));
  EXPECT_FALSE(read.error().advice.empty());
}

TEST(MalformedScenario, EachFaultIsNamedWithItsPlace) {
  for (const test::BrokenScenario& row : test::brokenScenarios()) {
    SCOPED_TRACE(row.patch);
    expectRefused(test::broken(row), row.place, row.reason);
  }
}

TEST(MalformedScenario, SyntaxErrorsHaveLineAndColumn) {
  expectRefused("{\n  \"format\": \"glissade-scenario\",\n  oops\n}", "line 3, column 3", "not valid JSON");
  expectRefused("", "", "empty");
  expectRefused("{\"a\": NaN}", "line 1, column 7", "not valid JSON");
  expectRefused("{\"a\": 1e999}", "", "out of range");
  expectRefused("{\"a\": 1, \"a\": 2}", "", "'a' twice");
  expectRefused("\xff\xfe{", "line 1", "not valid JSON");
  const std::string good = writeScenario(test::fullScenario());
  for (std::size_t length = 1; length + 2 < good.size(); length += 37) {
    EXPECT_FALSE(parseScenario(good.substr(0, length), "truncated").ok()) << length;
  }
}

TEST(MalformedScenario, DeepDocumentsAreRefused) {
  expectRefused(std::string(8'000'000, '['), "", "too deeply");
  std::string deep;
  for (int i = 0; i < 1'000'000; ++i) deep += "{\"a\":";
  expectRefused(deep, "", "too deeply");
}

/// The time to read such an object was quadratic in its keys: hours for a million keys.
TEST(MalformedScenario, ObjectsOfVeryManyKeysAreRefused) {
  std::string text = "{";
  for (int i = 0; i < 100'000; ++i) text += "\"k" + std::to_string(i) + "\": 0,";
  expectRefused(text + "\"k\": 0}", "", "more than 20000 keys");
}

TEST(MalformedScenario, TheValuesOfADocumentAreCounted) {
  std::size_t left = 5;
  EXPECT_TRUE(parseJson("[1, [2], {}]", "few.json", {}, left).ok());
  EXPECT_EQ(left, 0U);
  left = 4;
  const auto read = parseJson("[1, [2], {}]", "many.json", {}, left);
  ASSERT_FALSE(read.ok());
  EXPECT_THAT(toString(read.error().reason), HasSubstr("too many values"));
}

TEST(MalformedScenario, VeryManyBodiesAreRefused) {
  auto json = nlohmann::json::parse(writeScenario(test::boxScenario()));
  json["bodies"] = nlohmann::json::array_t(20'001, json["bodies"][0]["id"]);
  expectRefused(json.dump(), "/bodies", "more than 20000 entries");
}

TEST(MalformedScenario, TextsAreMadePrintable) {
  auto json = nlohmann::json::parse(writeScenario(test::boxScenario()));
  json["name"] = "red\x1b[31m";
  json["description"] = "two\nlines \u202e";
  const auto read = parseScenario(json.dump(), "control.json");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->name, "red\uFFFD[31m");
  EXPECT_EQ(read->description, "two\nlines \uFFFD");
}

TEST(MalformedScenario, AByteOrderMarkIsNoFault) {
  EXPECT_TRUE(parseScenario("\xEF\xBB\xBF" + writeScenario(test::fullScenario()), "bom.json").ok());
}

}  // namespace
}  // namespace glissade
