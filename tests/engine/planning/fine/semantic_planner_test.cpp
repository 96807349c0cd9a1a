#include "engine/planning/fine/semantic_planner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/planning/planner.h"
#include "tests/engine/support/shape_game.h"

namespace glissade {
namespace {

using testing::HasSubstr;

class SemanticPlanner : public testing::Test {
 protected:
  static const test::KnownGame& game() {
    static const test::KnownGame kGame("tight", "square");
    return kGame;
  }
  static ParsedRules parsed(const StrategyRules& rules) {
    return *parseRules(rules, AttributeTable(), {"linear", "rrt", "birrt"});
  }
  FineChoice choice(const char* place, const StrategyRules& rules, double distance = 1.0) const {
    return chooseFinePlanners(map, semantics, parsed(rules), test::placeNamed(semantics, place), distance);
  }

  const SemanticModel semantics = game().semantics();
  const TopologicalMap& map = game().knowledge->environment->map;
};

TEST_F(SemanticPlanner, HardPlacesGetTheGeometricalPlannerAndATreeEasyOnesAStraightLine) {
  const StrategyRules rules = presetRules("gts2");
  for (const char* place : {"P2", "P6", "P9"}) {  // cluttered, narrow and narrow places
    EXPECT_TRUE(choice(place, rules).geometrical) << place;
    EXPECT_EQ(choice(place, rules).local, "rrt") << place;
  }
  for (const char* place : {"P1", "P3", "P5"}) {
    EXPECT_FALSE(choice(place, rules).geometrical) << place;
    EXPECT_EQ(choice(place, rules).local, "linear") << place;
  }
  EXPECT_THAT(toString(choice("P2", rules).why), HasSubstr("cluttered"));
  EXPECT_THAT(toString(choice("P6", rules).why), HasSubstr("complexity 4"));
}

TEST_F(SemanticPlanner, TheFirstRuleThatHoldsDecides) {
  StrategyRules rules = presetRules("gt");
  rules.fine = {{"distance > 2", true, "birrt"}, {"place.complexity > 1", false, "rrt"}, {"1", false, "linear"}};
  EXPECT_EQ(choice("P6", rules, 3.0).local, "birrt");
  EXPECT_EQ(choice("P6", rules, 1.0).local, "rrt");
  EXPECT_EQ(choice("P1", rules, 1.0).local, "linear");
  EXPECT_EQ(fallbackFor(parsed(rules), choice("P1", rules)).local, "birrt");
  EXPECT_TRUE(fallbackFor(parsed(rules), choice("P1", rules)).geometrical);
}

TEST_F(SemanticPlanner, TheAreaIsThePlaceWithItsBordersOrTheSurroundingsOfAWay) {
  const int place = test::placeNamed(semantics, "P2");
  std::vector<int> borders;
  for (std::size_t b = 0; b < map.borders.size(); ++b) {
    if (map.borders[b].placeA == place || map.borders[b].placeB == place) borders.push_back(static_cast<int>(b));
  }
  ASSERT_GE(borders.size(), 2U);
  const auto centreOf = [&](int b) { return Pose::translation(map.borders[static_cast<std::size_t>(b)].centre); };
  const auto area = [&](bool geometrical) {
    return areaOf(*game().knowledge, place, borders.front(), borders.back(), geometrical, centreOf(borders.front()),
                  centreOf(borders.back()), game().loaded.problem.world->objectRadius());
  };
  const auto whole = area(false);
  const auto& cells = map.places[static_cast<std::size_t>(place)].cells;
  EXPECT_TRUE(std::includes(whole->cells().begin(), whole->cells().end(), cells.begin(), cells.end()));
  for (const int b : {borders.front(), borders.back()}) {
    const auto& overlap = map.borders[static_cast<std::size_t>(b)].cells;
    EXPECT_TRUE(std::includes(whole->cells().begin(), whole->cells().end(), overlap.begin(), overlap.end()));
  }
  const auto along = area(true);
  EXPECT_LT(along->cells().size(), whole->cells().size());
  EXPECT_TRUE(
      std::includes(whole->cells().begin(), whole->cells().end(), along->cells().begin(), along->cells().end()));
}

}  // namespace
}  // namespace glissade
