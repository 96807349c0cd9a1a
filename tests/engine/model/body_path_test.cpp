#include "engine/model/body_path.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

using Names = std::vector<std::string>;

TEST(BodyPath, IsTakenApartAtWholeNames) {
  EXPECT_EQ(stepsOf("pump/rotor/nut"), (Names{"pump", "rotor", "nut"}));
  EXPECT_EQ(stepsOf("nut"), Names{"nut"});
  EXPECT_EQ(stepsOf("//a//b/"), (Names{"a", "b"}));
  EXPECT_TRUE(stepsOf("").empty());
  EXPECT_EQ(firstStepOf("pump/rotor/nut"), "pump");
  EXPECT_EQ(lastStepOf("pump/rotor/nut"), "nut");
  EXPECT_EQ(lastStepOf("nut"), "nut");
  EXPECT_EQ(assembliesAbove("pump/rotor/nut"), (Names{"pump", "pump/rotor"}));
  EXPECT_TRUE(assembliesAbove("nut").empty());
  EXPECT_EQ(joinedPath("pump", "nut"), "pump/nut");
  EXPECT_EQ(joinedPath("", "nut"), "nut");
  EXPECT_EQ(joinedPath("pump", ""), "pump");
}

TEST(BodyPath, IsWithinItsAssembliesAndEndsInItsLastNames) {
  EXPECT_TRUE(isWithin("pump/rotor/nut", "pump/rotor"));
  EXPECT_TRUE(isWithin("pump/rotor/nut", ""));
  EXPECT_FALSE(isWithin("pump/rotors", "pump/rotor"));
  EXPECT_EQ(pathWithin("pump/rotor/nut", "pump"), "rotor/nut");
  EXPECT_EQ(pathWithin("pump", "pump"), "");
  EXPECT_TRUE(endsInPath("pump/rotor/nut", "rotor/nut"));
  EXPECT_TRUE(endsInPath("nut", "nut"));
  EXPECT_FALSE(endsInPath("pump/rotor/nut", "ut"));
}

}  // namespace
}  // namespace glissade
