#include "engine/planning/coarse/expression.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/base/random_stream.h"

namespace glissade {
namespace {

using testing::HasSubstr;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::optional<RuleType> known(const std::string& name) {
  if (name == "s") return RuleType::Text;
  const bool number = name == "x" || name == "y" || name == "order" || name == "a.b2";
  return number ? std::make_optional(RuleType::Number) : std::nullopt;
}

RuleValue lookUp(const std::string& name) {
  if (name == "s") return std::string("star");
  if (name == "order") return 5.0;
  if (name == "a.b2") return 7.0;
  return name == "x" ? 2.0 : 3.0;
}

double valueOf(const std::string& text) {
  const auto expression = Expression::parse(text, known);
  EXPECT_TRUE(expression.ok()) << text << ": " << (expression.ok() ? "" : toString(expression.error().reason));
  return expression.ok() ? expression->number(lookUp) : std::nan("");
}

TEST(Expression, BindsAsItsGrammarSays) {
  struct Row {
    const char* text;
    double value;
  };
  const std::vector<Row> rows{
      {"1 + 2 * 3", 7},
      {"(1 + 2) * 3", 9},
      {"10 - 4 - 3", 3},
      {"12 / 3 / 2", 2},
      {"2 - -2", 4},
      {"--2", 2},
      {"-x * y", -6},
      {"-(x + y)", -5},
      {"1 or 0 and 0", 1},
      {"(1 or 0) and 0", 0},
      {"not 0 and 0", 0},
      {"not (0 and 0)", 1},
      {"not 1 == 2", 1},
      {"not not 3", 1},
      {"1 + 1 == 2", 1},
      {"x < y and y > x", 1},
      {"x <= 2 and x >= 2", 1},
      {"x < 2 or x > 2", 0},
      {"2 * x != 4", 0},
      {"0 or 0", 0},
      {"order + 1", 6},
      {"a.b2 * 2", 14},
      {" \t\n1\n", 1},
      {".5 + 0.25", 0.75},
      {"1+2*3-4/2", 5},
      {"y - x - 1 == 0", 1},
      {"-1 < 0", 1},
      {"1 - 2 < 0", 1},
  };
  for (const Row& row : rows) EXPECT_EQ(valueOf(row.text), row.value) << row.text;
}

TEST(Expression, HasFunctions) {
  EXPECT_EQ(valueOf("min(3, x, 4)"), 2);
  EXPECT_EQ(valueOf("max(3, x, 4)"), 4);
  EXPECT_EQ(valueOf("min(7)"), 7);
  EXPECT_EQ(valueOf("abs(x - y)"), 1);
  EXPECT_EQ(valueOf("sqrt(9)"), 3);
  EXPECT_EQ(valueOf("log2(8)"), 3);
  EXPECT_EQ(valueOf("if(x > 1, 10, 20)"), 10);
  EXPECT_EQ(valueOf("if(x > 1 and 0, 10, 20)"), 20);
  EXPECT_EQ(valueOf("max(min(1, 2), if(1, 3, 4))"), 3);
}

TEST(Expression, WhatIsNoNumberCountsAsZero) {
  EXPECT_EQ(valueOf("infinite"), kInfinite);
  EXPECT_EQ(valueOf("infinite - infinite"), 0);
  EXPECT_EQ(valueOf("0 * infinite + 4"), 4);
  EXPECT_EQ(valueOf("sqrt(-1)"), 0);
  EXPECT_EQ(valueOf("log2(0) + log2(-1)"), 0);
}

TEST(Expression, DividingByZeroHasNoValueAndNeverHolds) {
  for (const char* text : {"1 / 0", "0 / 0", "-(x / 0) + 1", "max(1, 1 / 0)", "min(1 / 0, 1)", "if(1 / 0, 1, 2)",
                           "1 / 0 == 1 / 0", "not (1 / 0)", "1 or 1 / 0", "0 * (1 / 0)", "1 / 0 < 2"}) {
    EXPECT_TRUE(std::isnan(valueOf(text))) << text;
    EXPECT_FALSE(Expression::parse(text, known)->holds(lookUp)) << text;
  }
  EXPECT_EQ(valueOf("if(x == 0, 1, 6 / x)"), 3);
  EXPECT_EQ(valueOf("if(0, 1 / 0, 5)"), 5) << "only what is chosen counts";
}

TEST(Expression, TextsAreComparedAsTexts) {
  EXPECT_EQ(valueOf("s == \"star\""), 1);
  EXPECT_EQ(valueOf("s != \"star\""), 0);
  EXPECT_EQ(valueOf("s == \"Star\""), 0);
  EXPECT_EQ(valueOf("\"\" == \"\""), 1);
  EXPECT_EQ(valueOf("\"1\" == 1"), 0);
  EXPECT_EQ(valueOf("if(1, s, 0) == \"star\""), 1);
  EXPECT_EQ(valueOf("\"or ) 1 +\" == \"or ) 1 +\""), 1);
}

TEST(Expression, ErrorsNameTheColumn) {
  struct Row {
    const char* text;
    int column;
    const char* reason;
  };
  const std::vector<Row> rows{
      {"", 1, "ends too early"},
      {"1 +", 4, "ends too early"},
      {"(1", 3, "')' is missing"},
      {"1 2", 3, "'2' was not expected"},
      {"speed", 1, "'speed' is unknown"},
      {"1 + x.y", 5, "'x.y' is unknown"},
      {"min()", 5, "')' was not expected"},
      {"abs(1, 2)", 10, "wrong number of arguments"},
      {"if(1, 2)", 9, "wrong number"},
      {"\"abc", 1, "not closed"},
      {"1..2", 1, "not a number"},
      {"1 $ 2", 3, "was not expected"},
      {"1 < 2 < 3", 7, "was not expected"},
      {"min 1", 5, "'(' is missing"},
      {"x = 2", 3, "was not expected"},
      {"1e5", 2, "was not expected"},
      {")", 1, "was not expected"},
      {"or 1", 1, "'or' is unknown"},
      {"s", 1, "'s', a text, stands where a number is needed"},
      {"1 + s", 5, "stands where a number is needed"},
      {"x * 2 * s", 9, "stands where a number is needed"},
      {"s - 1", 1, "stands where a number is needed"},
      {" s < 2", 2, "stands where a number is needed"},
      {"2 >= s", 6, "stands where a number is needed"},
      {"-s", 2, "stands where a number is needed"},
      {"not s", 5, "stands where a number is needed"},
      {"x or s", 6, "stands where a number is needed"},
      {"min(x, s)", 8, "stands where a number is needed"},
      {"if(s, 1, 2)", 4, "stands where a number is needed"},
      {"1 + if(x, s, 2)", 5, "stands where a number is needed"},
      {"\"star\" + 1", 1, "a text stands where a number is needed"},
  };
  for (const Row& row : rows) {
    const auto expression = Expression::parse(row.text, known);
    ASSERT_FALSE(expression.ok()) << row.text;
    EXPECT_EQ(expression.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(toString(expression.error().location), "column " + std::to_string(row.column)) << row.text;
    EXPECT_THAT(toString(expression.error().reason), HasSubstr(row.reason)) << row.text;
    EXPECT_FALSE(expression.error().advice.empty());
  }
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(Expression, WhatAPersonWouldWriteIsNotTooDeep) {
  EXPECT_EQ(valueOf(repeated("(", 30) + "x" + repeated(")", 30)), 2);
  EXPECT_EQ(valueOf("0" + repeated(" + 1", 500)), 500);
}

TEST(Expression, DeepAndEndlessRulesAreRefused) {
  for (const char* piece : {"(", "-", "not ", "min(", "if(1, ", "1+", "x and ", "1 * (", "\"a\" == ("}) {
    for (const int times : {5000, 1'000'000}) {
      const auto expression = Expression::parse(repeated(piece, times) + "1", known);
      ASSERT_FALSE(expression.ok()) << piece;
      EXPECT_EQ(expression.error().kind, ErrorKind::MalformedInput);
      EXPECT_LT(toString(expression.error().advice).size(), 300U) << "the message repeats the whole rule";
    }
  }
}

TEST(Expression, GarbageIsRefusedOrHasAValue) {
  const std::vector<std::string> tokens{"(",
                                        ")",
                                        "+",
                                        "-",
                                        "*",
                                        "/",
                                        "<",
                                        "<=",
                                        "==",
                                        "!=",
                                        ",",
                                        "or",
                                        "and",
                                        "x",
                                        "y",
                                        "s",
                                        "1",
                                        "0.5",
                                        "\"",
                                        "q",
                                        "if",
                                        "min",
                                        "abs",
                                        " ",
                                        ".",
                                        "not",
                                        "infinite",
                                        "log2",
                                        "\xff",
                                        "0",
                                        std::string(1, '\0')};
  RandomStream stream(21, "garbage");
  int parsed = 0;
  for (int trial = 0; trial < 60000; ++trial) {
    std::string text;
    const int length = 1 + static_cast<int>(stream.uniform(0, 12));
    for (int i = 0; i < length; ++i) {
      text += tokens[static_cast<std::size_t>(stream.uniform(0, static_cast<double>(tokens.size())))];
      if (stream.uniform() < 0.5) text += ' ';
    }
    const auto expression = Expression::parse(text, known);
    if (!expression.ok()) continue;
    ++parsed;
    const bool divides = text.find('/') != std::string::npos;
    EXPECT_TRUE(divides || !std::isnan(expression->number(lookUp))) << text;
    EXPECT_EQ(expression->text(), text);
  }
  EXPECT_GT(parsed, 1000);
}

}  // namespace
}  // namespace glissade
