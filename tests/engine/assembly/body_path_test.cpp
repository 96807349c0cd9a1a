#include "engine/assembly/body_path.h"

#include <gtest/gtest.h>

#include <set>

#include "engine/base/random_stream.h"

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

TEST(BodyPath, TheShownNameIsTheShortestEndThatIsUnique) {
  const Names names{"a/left/nut", "a/right/nut", "a/right/bolt", "plate", "x/plate", "twice", "twice"};
  const Names ids{"1", "2", "3", "4", "5", "six", "seven"};
  EXPECT_EQ(shownNames(ids, names), (Names{"left/nut", "right/nut", "bolt", "plate", "x/plate", "six", "seven"}));
}

/// Each shown name ends its own path, no other one, and no shorter end does.
TEST(BodyPath, ShownNamesOfRandomTrees) {
  RandomStream random(1, "trees");
  const auto word = [&] { return std::string(1, static_cast<char>('a' + static_cast<int>(random.uniform(0.0, 3.0)))); };
  for (int round = 0; round < 200; ++round) {
    std::set<std::string> paths;
    const int count = 1 + static_cast<int>(random.uniform(0.0, 12.0));
    for (int i = 0; i < count; ++i) {
      std::string path = word();
      for (int depth = static_cast<int>(random.uniform(0.0, 5.0)); depth > 0; --depth) path = joinedPath(path, word());
      paths.insert(path);
    }
    const Names names(paths.begin(), paths.end());
    const Names shown = shownNames(names, names);
    EXPECT_EQ(std::set<std::string>(shown.begin(), shown.end()).size(), names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
      ASSERT_TRUE(endsInPath(names[i], shown[i]));
      const auto matches = [&](const std::string& end) {
        return std::count_if(names.begin(), names.end(),
                             [&](const std::string& name) { return endsInPath(name, end); });
      };
      if (shown[i] != names[i]) {
        EXPECT_EQ(matches(shown[i]), 1) << shown[i];
      }
      const Names above = assembliesAbove(shown[i]);
      if (!above.empty()) {
        EXPECT_GT(matches(pathWithin(shown[i], above.front())), 1) << shown[i];
      }
    }
  }
}

}  // namespace
}  // namespace glissade
