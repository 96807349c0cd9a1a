#include "engine/places/edit_binding.h"

#include <gtest/gtest.h>

#include "tests/engine/support/environment_worlds.h"

namespace glissade {
namespace {

using test::kFarAway;
using test::kHole;
using test::kInTheWall;
using test::kLeft;

class EditBinding : public testing::Test {
 protected:
  const EnvironmentModelPtr environment =
      test::environmentOf(test::wallWithAHole(), test::twoRooms(), {1.0 / 32, 16, 6, "region-growing"});
  const TopologicalMap& map = environment->map;

  std::vector<std::string> placesOf(const SemanticEdits& edits) const {
    std::vector<std::string> places;
    for (const Diagnostic& warning : editWarnings(map, edits)) {
      EXPECT_FALSE(warning.reason.empty());
      EXPECT_FALSE(warning.advice.empty());
      places.push_back(toString(warning.location));
    }
    return places;
  }
};

TEST_F(EditBinding, APlaceIsThatOfThePointOrTheNearestButNoneIsFarAway) {
  EXPECT_EQ(boundPlace(map, kHole), map.placeAt(kHole));
  EXPECT_EQ(boundPlace(map, kInTheWall), map.placeAt(kLeft));
  EXPECT_EQ(boundPlace(map, kFarAway), kNoPlace);
  EXPECT_EQ(boundPlace(TopologicalMap(), kLeft), kNoPlace);
}

TEST_F(EditBinding, AMilestoneIsForTheBorderThatHoldsItOrTheNearest) {
  ASSERT_FALSE(map.borders.empty());
  for (std::size_t i = 0; i < map.borders.size(); ++i) {
    const std::vector<std::size_t>& cells = map.borders[i].cells;
    const std::vector<int> bound = boundBorders(map, map.grid.centre(cells[cells.size() / 2]));
    EXPECT_NE(std::find(bound.begin(), bound.end(), static_cast<int>(i)), bound.end());
  }
  EXPECT_EQ(boundBorders(map, {0.95, 0.36, 0.5}).size(), 1U) << "in the wall, beside the hole";
  EXPECT_TRUE(boundBorders(map, kFarAway).empty());
}

TEST_F(EditBinding, WhatIsSoundIsNotWarnedOf) {
  SemanticEdits edits;
  edits.places = {{kLeft, "P2", {}}, {{1.7, 0.5, 0.5}, "P1", {}}, {kHole, "Door", {{"forbidden", true}}}};
  edits.milestones = {{map.borders.front().centre, Pose()}};
  EXPECT_EQ(placesOf(edits), std::vector<std::string>());
}

TEST_F(EditBinding, WhatCountsNowhereOrElsewhereOrTwiceIsWarnedOfWithItsPlace) {
  SemanticEdits edits;
  edits.places = {{kFarAway, "Hall", {}}, {kLeft, "Hall", {}},         {kInTheWall, "", {{"forbidden", true}}},
                  {kHole, "Hall", {}},    {{1.7, 0.5, 0.5}, "P3", {}}, {kHole, "Door", {}}};
  edits.milestones = {{kFarAway, Pose()}};
  EXPECT_EQ(placesOf(edits), (std::vector<std::string>{"/places/0", "/places/2", "/places/2", "/places/5", "/places/3",
                                                       "/milestones/0"}));
}

TEST_F(EditBinding, StraysAreThoseThatCountNowhereAndNoOthers) {
  SemanticEdits edits;
  const MilestoneEdit milestone{map.borders.front().centre, Pose()};
  edits.places = {{kFarAway, "Hall", {}}, {kLeft, "Hall", {}}, {kInTheWall, "", {{"forbidden", true}}}};
  edits.milestones = {{kFarAway, Pose()}, milestone};
  edits.bodies["gone"] = {{"fragile", true}};
  SemanticEdits expected = edits;
  expected.places.erase(expected.places.begin());
  expected.milestones = {milestone};
  EXPECT_TRUE(withoutStrays(map, edits) == expected);
}

}  // namespace
}  // namespace glissade
