#include "engine/places/forbidden_places.h"

#include <gtest/gtest.h>

#include <set>

#include "engine/base/random_stream.h"
#include "tests/engine/support/environment_worlds.h"

namespace glissade {
namespace {

CellGrid smallGrid() {
  CellGrid grid;
  grid.frame = {Vector3(-0.3, 0.1, 0.7), 1.6};
  grid.level = 3;
  grid.counts = {7, 6, 8};
  return grid;
}

std::vector<std::size_t> someCells(const CellGrid& grid, double share, std::uint64_t seed) {
  RandomStream stream(seed, "cells");
  std::vector<std::size_t> cells;
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    if (stream.uniform() < share) cells.push_back(cell);
  }
  return cells;
}

bool isInside(const std::vector<Box3>& boxes, const Vector3& p) {
  return std::any_of(boxes.begin(), boxes.end(), [&](const Box3& box) {
    return (p.array() > box.min().array()).all() && (p.array() < box.max().array()).all();
  });
}

TEST(BoxesOfCells, CoverTheCellsAndNothingElse) {
  const CellGrid grid = smallGrid();
  for (const double share : {0.1, 0.5, 0.9}) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const auto cells = someCells(grid, share, seed);
      const auto boxes = boxesOfCells(grid, cells);
      const std::set<std::size_t> wanted(cells.begin(), cells.end());
      for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        EXPECT_EQ(isInside(boxes, grid.centre(cell)), wanted.count(cell) > 0);
      }
      EXPECT_LE(boxes.size(), 27 * cells.size());
    }
  }
}

/// A motion along the plane between two cells of a place is inside the place.
TEST(BoxesOfCells, HoldWhatIsBetweenNeighbours) {
  const CellGrid grid = smallGrid();
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto cells = someCells(grid, 0.8, seed);
    const auto boxes = boxesOfCells(grid, cells);
    const std::set<std::size_t> wanted(cells.begin(), cells.end());
    // A corner of cells is inside if all eight cells around it are.
    for (int x = 1; x < grid.counts[0]; ++x) {
      for (int y = 1; y < grid.counts[1]; ++y) {
        for (int z = 1; z < grid.counts[2]; ++z) {
          bool all = true;
          for (int n = 0; n < 8; ++n) {
            all = all && wanted.count(grid.at(x - (n & 1), y - (n >> 1 & 1), z - (n >> 2 & 1))) > 0;
          }
          const Vector3 corner = grid.frame.origin + grid.cellSize() * Vector3(x, y, z);
          EXPECT_EQ(isInside(boxes, corner), all);
        }
      }
    }
  }
}

TEST(BoxesOfCells, OfARoomAreOne) {
  const CellGrid grid = smallGrid();
  EXPECT_EQ(boxesOfCells(grid, someCells(grid, 2.0, 1)).size(), 1U);
  EXPECT_TRUE(boxesOfCells(grid, {}).empty());
}

TEST(ForbiddenPlaces, AreThoseOfTheEditsInTheirLastWord) {
  const auto model =
      test::environmentOf(test::wallWithAHole(), test::twoRooms(), {2.0 / 64.0, 16.0, 5, "region-growing"});
  ASSERT_NE(model, nullptr);
  const TopologicalMap& map = model->map;
  SemanticEdits edits;
  EXPECT_FALSE(forbidsPlaces(edits));
  edits.places = {{test::kHole, "the hole", {{"forbidden", true}}}, {test::kLeft, "", {{"forbidden", true}}}};
  EXPECT_TRUE(forbidsPlaces(edits));
  auto places = forbiddenPlacesOf(map, edits);
  ASSERT_TRUE(places.ok());
  ASSERT_EQ(places->size(), 2U);
  for (const ForbiddenPlace& place : *places) {
    const bool hole = place.name == "the hole";
    EXPECT_TRUE(isInside(place.boxes, hole ? test::kHole : test::kLeft));
    EXPECT_FALSE(isInside(place.boxes, hole ? test::kLeft : test::kHole));
  }
  edits.places.push_back({test::kLeft, "", {{"forbidden", false}}});
  places = forbiddenPlacesOf(map, edits);
  ASSERT_TRUE(places.ok());
  EXPECT_EQ(places->size(), 1U);
  EXPECT_TRUE(*places == *forbiddenPlacesOf(map, edits));
  edits.places.push_back({test::kFarAway, "", {{"forbidden", true}}});
  places = forbiddenPlacesOf(map, edits);
  ASSERT_FALSE(places.ok());
  EXPECT_EQ(toString(places.error().location), "/places/3");
}

}  // namespace
}  // namespace glissade
