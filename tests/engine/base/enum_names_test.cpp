#include "engine/base/enum_names.h"

#include <gtest/gtest.h>

#include "engine/base/json_reader.h"

namespace glissade {
namespace {

enum class Side { Left, Right };
constexpr EnumNames<Side, 2> kSideNames{{"left", "right"}};

TEST(EnumNames, AreFoundAndListed) {
  for (const Side side : {Side::Left, Side::Right}) EXPECT_EQ(kSideNames.find(kSideNames.of(side)), side);
  EXPECT_FALSE(kSideNames.find("up"));
  EXPECT_FALSE(kSideNames.find(""));
  EXPECT_EQ(kSideNames.listed(), "left, right");
}

TEST(EnumNames, AnUnknownNameInADocumentIsRefusedWithAllNames) {
  const auto read = [](const std::string& text) {
    return readJson(text, "file.json", [](const JsonCursor& root) { return root.at("side").named(kSideNames); });
  };
  EXPECT_EQ(*read(R"({"side": "right"})"), Side::Right);
  const auto refused = read(R"({"side": "up"})");
  ASSERT_FALSE(refused);
  EXPECT_EQ(toString(refused.error().location), "/side");
  EXPECT_EQ(toString(refused.error().reason), "is not one of: left, right");
}

}  // namespace
}  // namespace glissade
