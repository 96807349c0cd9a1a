#include "engine/places/free_space.h"

#include <gtest/gtest.h>

#include "engine/base/random_stream.h"
#include "tests/engine/support/environment_worlds.h"

namespace glissade {
namespace {

FreeSpace emptySpace(const std::array<int, 3>& counts) {
  FreeSpace space;
  space.grid.frame = {Vector3(-1, 2, 0), 4.0};
  space.grid.level = 3;  // cells of 0.5
  space.grid.counts = counts;
  space.kinds.assign(space.grid.size(), CellKind::Free);
  return space;
}

/// Distance to the nearest closed cell, or cell just outside the workspace, by testing all.
double nearestClosed(const FreeSpace& space, std::size_t cell, bool mobileToo) {
  const auto closed = [&](std::size_t other) {
    return space.kinds[other] == CellKind::Static || (mobileToo && space.kinds[other] == CellKind::Mobile);
  };
  if (closed(cell)) return 0.0;
  double nearest = 1e300;
  const auto c = space.grid.coordinates(cell);
  for (std::size_t a = 0; a < 3; ++a) {
    nearest =
        std::min({nearest, space.grid.cellSize() * (c[a] + 1), space.grid.cellSize() * (space.grid.counts[a] - c[a])});
  }
  for (std::size_t other = 0; other < space.grid.size(); ++other) {
    if (closed(other)) nearest = std::min(nearest, (space.grid.centre(other) - space.grid.centre(cell)).norm());
  }
  return nearest;
}

TEST(DistanceTransform, AgreesWithAskingEveryPairOfCells) {
  RandomStream stream(3, "grids");
  for (int trial = 0; trial < 30; ++trial) {
    FreeSpace space = emptySpace({1 + trial % 8, 7, 3 + trial % 5});
    const double share = trial < 3 ? 0.0 : stream.uniform(0.0, 0.4);
    for (CellKind& kind : space.kinds) {
      if (stream.uniform() < share) kind = stream.uniform() < 0.5 ? CellKind::Static : CellKind::Mobile;
    }
    for (const bool mobileToo : {false, true}) {
      const std::vector<double> distance = distanceTransform(space, mobileToo);
      ASSERT_EQ(distance.size(), space.grid.size());
      for (std::size_t cell = 0; cell < distance.size(); ++cell) {
        EXPECT_NEAR(distance[cell], nearestClosed(space, cell, mobileToo), 1e-12) << "trial " << trial;
      }
    }
  }
}

TEST(CellGrid, FindsEveryCellByItsCentreAndNothingOutside) {
  const CellGrid grid = emptySpace({3, 4, 5}).grid;
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    EXPECT_EQ(grid.find(grid.centre(cell)), cell);
    const auto c = grid.coordinates(cell);
    EXPECT_EQ(grid.at(c[0], c[1], c[2]), cell);
    int neighbours = 0;
    grid.forEachNeighbour(cell, [&](std::size_t next) {
      EXPECT_NEAR((grid.centre(next) - grid.centre(cell)).norm(), grid.cellSize(), 1e-12);
      ++neighbours;
    });
    int rims = 0;
    for (std::size_t a = 0; a < 3; ++a) rims += (c[a] == 0 ? 1 : 0) + (c[a] + 1 == grid.counts[a] ? 1 : 0);
    EXPECT_EQ(neighbours, 6 - rims);
  }
  const Box3 all(grid.box(0).min(), grid.box(grid.size() - 1).max());
  EXPECT_EQ(grid.find(all.max()), grid.size() - 1);  // the far corner belongs to the last cell
  EXPECT_FALSE(grid.find(all.max() + Vector3(0.01, 0, 0)));
  EXPECT_FALSE(grid.find(all.min() - Vector3(0, 0, 0.01)));
  EXPECT_FALSE(grid.find(Vector3::Constant(std::nan(""))));
}

TEST(FreeSpace, ACellIsOfTheWorstKindWithin) {
  RandomStream stream(2, "bodies");
  const std::vector<RigidBody> bodies = test::randomBodies(stream, 5);
  const Octree octree(bodies, Box3(Vector3::Zero(), Vector3(1.0, 0.7, 0.5)), {1.0 / 32, 0});
  ASSERT_EQ(octree.depth(), 5);
  for (const int level : {2, 4, 5}) {
    const FreeSpace space = freeSpaceOf(octree, level);
    const int across = 1 << level;
    EXPECT_EQ(space.grid.counts, (std::array<int, 3>{across, (7 * across + 9) / 10, across / 2}));
    std::vector<CellKind> worst(space.grid.size(), CellKind::Free);
    const auto shift = static_cast<unsigned>(5 - level);
    for (std::uint32_t x = 0; x < 32; ++x) {
      for (std::uint32_t y = 0; y < 32; ++y) {
        for (std::uint32_t z = 0; z < 32; ++z) {
          const std::array<int, 3> c{static_cast<int>(x >> shift), static_cast<int>(y >> shift),
                                     static_cast<int>(z >> shift)};
          if (!space.grid.contains(c)) continue;
          CellKind& kind = worst[space.grid.at(c[0], c[1], c[2])];
          kind = std::max(kind, octree.clutterAt({x, y, z}).kind());
        }
      }
    }
    EXPECT_EQ(space.kinds, worst) << "level " << level;
  }
}

}  // namespace
}  // namespace glissade
