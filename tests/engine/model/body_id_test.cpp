#include "engine/model/body_id_json.h"

#include <gtest/gtest.h>

#include <type_traits>
#include <unordered_set>

namespace glissade {
namespace {

static_assert(!std::is_convertible_v<std::string, BodyId>, "a name for people is no id");
static_assert(!std::is_convertible_v<BodyId, std::string>, "an id is no name for people");

TEST(BodyId, ComparesAndOrdersByItsText) {
  const std::string text = "pump/rotor";
  const BodyId id(text);
  EXPECT_EQ(id.text(), text);
  EXPECT_EQ(id, "pump/rotor");
  EXPECT_NE(id, "pump");
  EXPECT_LT(BodyId("pump"), id);
  EXPECT_EQ(std::unordered_set<BodyId>({id, "pump", id}).size(), 2U);
}

TEST(BodyId, NamesNoBodyByDefault) {
  EXPECT_TRUE(BodyId().empty());
  EXPECT_FALSE(BodyId("pump").empty());
}

TEST(BodyId, IsTheTextInAFile) {
  const BodyId id("pump");
  const JsonCursor::Json json = kBodyId.write(id);
  EXPECT_EQ(json.dump(), R"("pump")");
  EXPECT_EQ(kBodyId.read(JsonCursor(json, "", "")), id);
  EXPECT_EQ(textsOf({id, "rotor"}), (std::vector<std::string>{"pump", "rotor"}));
}

}  // namespace
}  // namespace glissade
