#include "widgets/scene3d/label_placement.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/random_stream.h"

namespace glissade {
namespace {

QRectF boxAt(double x, double y) { return {x, y, 30.0, 16.0}; }

TEST(LabelPlacement, WhoHasRoomIsWhereItWantsToBe) {
  const auto places = placeLabels({{boxAt(0, 0)}, {boxAt(100, 0)}, {boxAt(0, 40), true}});
  EXPECT_EQ(places[0], boxAt(0, 0));
  EXPECT_EQ(places[1], boxAt(100, 0));
  EXPECT_EQ(places[2], boxAt(0, 40));
}

TEST(LabelPlacement, NoneLiesOnAnother) {
  RandomStream stream(3, "labels");
  for (int round = 0; round < 50; ++round) {
    std::vector<WantedLabel> labels;
    for (int i = 0; i < 30; ++i) labels.push_back({boxAt(200.0 * stream.uniform(), 100.0 * stream.uniform())});
    const auto places = placeLabels(labels);
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_FALSE(places[i] && places[j] && places[i]->intersects(*places[j]));
      }
    }
  }
}

TEST(LabelPlacement, ABoundOneIsWhereItBelongsOrLeftOut) {
  const auto places = placeLabels({{boxAt(0, 0), false, true}, {boxAt(200, 0), false, true}, {boxAt(5, 0)}});
  EXPECT_EQ(places[0], std::nullopt) << "the others choose first";
  EXPECT_EQ(places[1], boxAt(200, 0));
  EXPECT_EQ(places[2], boxAt(5, 0));
}

TEST(LabelPlacement, InACrowdTheStrongOnesStayWhereTheyAreAndSomeAreLeftOut) {
  std::vector<WantedLabel> labels(12, {boxAt(50, 50)});
  labels.back().strong = true;
  const auto places = placeLabels(labels);
  EXPECT_EQ(places.back(), boxAt(50, 50));
  EXPECT_EQ(std::count(places.begin(), places.end(), std::nullopt), 3) << "nine places for twelve";
  std::vector<WantedLabel> allStrong(12, {boxAt(50, 50), true});
  for (const auto& place : placeLabels(allStrong)) EXPECT_TRUE(place);
}

}  // namespace
}  // namespace glissade
