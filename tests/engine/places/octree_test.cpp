#include "engine/places/octree.h"

#include <gtest/gtest.h>

#include "tests/engine/support/environment_worlds.h"

namespace glissade {
namespace {

const Box3 kUnitCube(Vector3::Zero(), Vector3::Ones());

RigidBody cube(const char* name, Mobility mobility, const Vector3& least, double edge) {
  RigidBody body = boxBody(name, Vector3::Constant(edge), Pose::translation(least + Vector3::Constant(edge / 2)));
  body.mobility = mobility;
  return body;
}

TEST(Octree, AnEmptyWorldIsOneFreeLeaf) {
  const Octree octree({}, kUnitCube, {0.125, 0});
  EXPECT_EQ(octree.leafCount(), 1U);
  EXPECT_EQ(octree.leafCounts(), (std::array<std::size_t, 3>{1, 0, 0}));
  EXPECT_EQ(octree.clutterAt({7, 7, 7}).kind(), CellKind::Free);
}

TEST(Octree, CellsHaveTheThreeKindsAndTwoListsOfBodies) {
  // A static and a mobile cube of one eighth each, and a second mobile one that overlaps both.
  const Octree octree(
      {cube("static", Mobility::Static, {0, 0, 0}, 0.5), cube("mobile", Mobility::Mobile, {0.5, 0, 0}, 0.5),
       cube("both", Mobility::Mobile, {0.25, 0, 0}, 0.5)},
      kUnitCube, {0.25, 0});
  ASSERT_EQ(octree.depth(), 2);
  EXPECT_EQ(octree.clutterAt({0, 0, 0}), (Clutter{{0}, {}}));
  EXPECT_EQ(octree.clutterAt({1, 1, 1}), (Clutter{{0}, {2}}));
  EXPECT_EQ(octree.clutterAt({2, 0, 1}), (Clutter{{}, {1, 2}}));
  EXPECT_EQ(octree.clutterAt({3, 1, 0}), (Clutter{{}, {1}}));
  EXPECT_EQ(octree.clutterAt({0, 2, 0}), Clutter{});
  EXPECT_EQ(octree.clutterAt({1, 1, 1}).kind(), CellKind::Static);
  EXPECT_EQ(octree.clutterAt({2, 0, 1}).kind(), CellKind::Mobile);
  // Two of the root's eight children are split.
  EXPECT_EQ(octree.leafCount(), 6U + 2U * 8U);
  EXPECT_EQ(octree.leafCounts(), (std::array<std::size_t, 3>{6, 8, 8}));
}

TEST(Octree, LeavesFillTheRootInZOrderAndCannotBeMerged) {
  RandomStream stream(4, "bodies");
  const Octree octree(test::randomBodies(stream, 5), kUnitCube, {1.0 / 32, 0});
  std::uint64_t next = 0;
  std::size_t leaves = 0;
  std::array<std::size_t, 3> kinds{};
  std::vector<std::pair<Cell, Clutter>> run;  // the last eight leaves
  octree.forEachLeaf([&](const Octree::Leaf& leaf) {
    const auto shift = static_cast<unsigned>(octree.depth() - leaf.cell.level);
    const auto& index = leaf.cell.index;
    EXPECT_EQ(mortonCode({index[0] << shift, index[1] << shift, index[2] << shift}), next);
    next += finestCellsIn(leaf.cell.level, octree.depth());
    ++leaves;
    ++kinds[static_cast<std::size_t>(leaf.clutter.kind())];
    EXPECT_EQ(leaf.kind, leaf.clutter.kind());
    run.emplace_back(leaf.cell, leaf.clutter);
    if (run.size() > 8) run.erase(run.begin());
    bool uniform = run.size() == 8 && (index[0] & index[1] & index[2] & 1U) != 0 && leaf.cell.level > 0;
    for (const auto& [cell, clutter] : run) {
      uniform = uniform && cell.level == leaf.cell.level && clutter == leaf.clutter;
    }
    EXPECT_FALSE(uniform) << "eight leaves should be one";
  });
  EXPECT_EQ(next, finestCellsIn(0, octree.depth()));
  EXPECT_EQ(leaves, octree.leafCount());
  EXPECT_EQ(kinds, octree.leafCounts());
  for (const std::size_t count : kinds) EXPECT_GT(count, 0U);
}

TEST(Octree, IsAsDeepAsTheCellSizeAsks) {
  struct Row {
    double cellSize;
    int depth;
  };
  for (const Row& row : {Row{2.0, 1}, Row{0.5, 1}, Row{0.25, 2}, Row{0.2499, 3}, Row{0.1, 4}, Row{1.0 / 64, 6},
                         Row{1e-6, Octree::kDeepest}}) {
    EXPECT_EQ(Octree({}, kUnitCube, {row.cellSize, 0}).depth(), row.depth) << row.cellSize;
  }
  // The longest edge of the workspace determines the depth.
  EXPECT_EQ(Octree({}, Box3(Vector3::Zero(), Vector3(1, 4, 2)), {0.5, 0}).depth(), 3);
}

TEST(Octree, IsAsDeepAsTheMemoryAllows) {
  RandomStream stream(6, "bodies");
  const std::vector<RigidBody> bodies = test::randomBodies(stream, 6);
  int before = 0;
  for (const std::size_t memory :
       {std::size_t{1}, std::size_t{200} << 10, std::size_t{1} << 20, std::size_t{8} << 20}) {
    const Octree octree(bodies, kUnitCube, {0.0, memory});
    const std::size_t nodes = (octree.leafCount() - 1) / 7 * 8 + 1;
    if (octree.depth() > 4) {
      EXPECT_LE(nodes * 8, memory);
    }
    EXPECT_GE(octree.depth(), std::max(before, 4));
    before = octree.depth();
  }
  EXPECT_GT(before, 5);
}

TEST(Octree, IsNotEqualWhereOneCellDiffers) {
  const std::vector<RigidBody> bodies{cube("a", Mobility::Mobile, {0.25, 0.25, 0.25}, 0.25)};
  const Octree octree(bodies, kUnitCube, {0.25, 0});
  std::vector<RigidBody> other = bodies;
  EXPECT_TRUE(octree == Octree(other, kUnitCube, {0.25, 0}));
  EXPECT_FALSE(octree == Octree(other, kUnitCube, {0.125, 0}));
  other[0].mobility = Mobility::Static;
  EXPECT_FALSE(octree == Octree(other, kUnitCube, {0.25, 0}));
  other = bodies;
  other[0].X_WB.position.x() += 0.25;
  EXPECT_FALSE(octree == Octree(other, kUnitCube, {0.25, 0}));
}

}  // namespace
}  // namespace glissade
