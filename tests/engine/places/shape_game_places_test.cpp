// Every identifier finds the nine places of paper 2's shape game (figure 13).
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/places/edit_binding.h"
#include "tests/engine/support/shape_game.h"

namespace glissade {
namespace {

class ShapeGamePlaces : public testing::TestWithParam<const char*> {
 protected:
  static EnvironmentModelPtr build() {
    EnvironmentOptions options = game().problem.scene.environment;
    options.identifier = GetParam();
    auto built = buildEnvironment(game().obstacles, game().problem.bounds, options);
    return built ? *built : nullptr;
  }
  static SemanticModel semantics(const EnvironmentModelPtr& model) {
    return SemanticModel(model, game().obstacles, "circle", *game().problem.scene.edits);
  }
  static const LoadedScenario& game() {
    static const LoadedScenario kGame = test::shapeGame("tight", "circle");
    return kGame;
  }
};

TEST_P(ShapeGamePlaces, EachNameHasAPlaceOfItsOwn) {
  const auto model = build();
  ASSERT_NE(model, nullptr);
  const SemanticModel semantic = semantics(model);
  EXPECT_TRUE(editWarnings(model->map, *game().problem.scene.edits).empty());
  std::set<std::string> names;
  for (std::size_t place = 0; place < semantic.placeCount(); ++place) names.insert(semantic.placeName(place));
  EXPECT_EQ(names, (std::set<std::string>{"P1", "P2", "P3", "P4", "P5", "P6", "P7", "P8", "P9"}));
  EXPECT_EQ(semantic.placeCount(), 9U);
}

TEST_P(ShapeGamePlaces, BordersConnectWhatTheHolesAndGapsJoin) {
  const auto model = build();
  ASSERT_NE(model, nullptr);
  const SemanticModel semantic = semantics(model);
  std::set<std::string> joined;
  for (const Border& border : model->map.borders) {
    const auto [a, b] = std::minmax({semantic.placeName(static_cast<std::size_t>(border.placeA)),
                                     semantic.placeName(static_cast<std::size_t>(border.placeB))});
    joined.insert(a + "-" + b);
  }
  EXPECT_EQ(joined, (std::set<std::string>{"P1-P6", "P1-P7", "P1-P8", "P1-P9", "P2-P6", "P2-P7", "P2-P8", "P2-P9",
                                           "P2-P4", "P2-P5", "P3-P4", "P3-P5"}));
}

TEST_P(ShapeGamePlaces, HolesAreNarrowPassagesAndOnlyP2IsCluttered) {
  const auto model = build();
  ASSERT_NE(model, nullptr);
  const SemanticModel semantic = semantics(model);
  for (std::size_t place = 0; place < semantic.placeCount(); ++place) {
    const std::string& name = semantic.placeName(place);
    const bool hole = name >= "P6";
    EXPECT_EQ(model->cluttered[place], name == "P2") << name;
    EXPECT_TRUE(model->map.places[place].passage || !hole) << name;
    const double complexity = hole ? 4.0 : name == "P4" ? 3.0 : 1.0;
    EXPECT_EQ(std::get<double>(semantic.ofPlace(place, "complexity").value), complexity) << name;
  }
  // Inscribed circles of the tight preset, with a tolerance of a fifth of a cell.
  const auto narrowness = [&](const char* name) {
    return model->map.places[static_cast<std::size_t>(test::placeNamed(semantic, name))].narrowness;
  };
  EXPECT_NEAR(narrowness("P6"), 0.124, 0.004);
  EXPECT_NEAR(narrowness("P7"), 0.123, 0.004);
  EXPECT_LT(narrowness("P4"), narrowness("P5"));
}

TEST_P(ShapeGamePlaces, AreTheSameInEveryBuild) {
  const auto first = build();
  const auto second = build();
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->map.placeOf, second->map.placeOf);
  EXPECT_EQ(first->clearance, second->clearance);
  ASSERT_EQ(first->map.places.size(), second->map.places.size());
  for (std::size_t i = 0; i < first->map.places.size(); ++i) {
    EXPECT_EQ(first->map.places[i].name, second->map.places[i].name);
    EXPECT_EQ(first->map.places[i].anchor, second->map.places[i].anchor);
  }
  ASSERT_EQ(first->map.borders.size(), second->map.borders.size());
  for (std::size_t i = 0; i < first->map.borders.size(); ++i) {
    EXPECT_EQ(first->map.borders[i].name, second->map.borders[i].name);
    EXPECT_EQ(first->map.borders[i].cells, second->map.borders[i].cells);
  }
}

INSTANTIATE_TEST_SUITE_P(Identifiers, ShapeGamePlaces, testing::Values("region-growing", "watershed"),
                         [](const auto& parameter) {
                           return std::string(parameter.param) == "watershed" ? "Watershed" : "RegionGrowing";
                         });

}  // namespace
}  // namespace glissade
